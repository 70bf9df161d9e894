//! Points and lines with their values as legacy VTK (version 3.0, binary), which `ParaView` and others
//! read: numbers keep all their bits, and files of a million points stay small.

/// Values of a name, so many per point or line.
struct Values {
    name: &'static str,
    /// Numbers of each.
    width: usize,
    numbers: Numbers,
}

enum Numbers {
    Real(Vec<f64>),
    Whole(Vec<u32>),
}

/// Points, or lines between two points each, in the plane z = 0.
pub struct Polydata {
    title: String,
    points: Vec<[f64; 2]>,
    /// Points of each cell: 1 or 2.
    ends: usize,
    values: Vec<Values>,
}

impl Polydata {
    /// Points [m], each a cell.
    pub fn points(title: &str, points: Vec<[f64; 2]>) -> Self {
        Self::of(title, points, 1)
    }

    /// Lines [m], each a cell of its own.
    pub fn lines(title: &str, lines: Vec<[[f64; 2]; 2]>) -> Self {
        Self::of(title, lines.into_iter().flatten().collect(), 2)
    }

    fn of(title: &str, points: Vec<[f64; 2]>, ends: usize) -> Self {
        // The second line of a file, at most 255 characters.
        let title = title.chars().filter(|c| !c.is_control());
        Self {
            title: title.take(200).collect(),
            points,
            ends,
            values: Vec::new(),
        }
    }

    /// Points or lines.
    fn count(&self) -> usize {
        self.points.len() / self.ends
    }

    fn add(&mut self, name: &'static str, width: usize, numbers: Numbers) {
        let found = match &numbers {
            Numbers::Real(numbers) => numbers.len(),
            Numbers::Whole(numbers) => numbers.len(),
        };
        assert_eq!(found, width * self.count(), "{name}: a value for each");
        self.values.push(Values {
            name,
            width,
            numbers,
        });
    }

    /// Adds a number for each.
    ///
    /// # Panics
    /// If there are more or fewer.
    pub fn scalar(&mut self, name: &'static str, numbers: impl Iterator<Item = f64>) {
        self.add(name, 1, Numbers::Real(numbers.collect()));
    }

    /// Adds a whole number for each.
    ///
    /// # Panics
    /// If there are more or fewer.
    pub fn whole(&mut self, name: &'static str, numbers: impl Iterator<Item = u32>) {
        self.add(name, 1, Numbers::Whole(numbers.collect()));
    }

    /// Adds a vector in the plane for each.
    ///
    /// # Panics
    /// If there are more or fewer.
    pub fn vector(&mut self, name: &'static str, vectors: impl Iterator<Item = [f64; 2]>) {
        let numbers = vectors.flat_map(|[x, y]| [x, y, 0.0]).collect();
        self.add(name, 3, Numbers::Real(numbers));
    }

    /// The bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        let count = self.count();
        let mut bytes = Vec::new();
        let line = |bytes: &mut Vec<u8>, text: String| {
            bytes.extend_from_slice(text.as_bytes());
            bytes.push(b'\n');
        };
        line(&mut bytes, "# vtk DataFile Version 3.0".into());
        line(&mut bytes, self.title.clone());
        line(&mut bytes, "BINARY\nDATASET POLYDATA".into());
        line(&mut bytes, format!("POINTS {} double", self.points.len()));
        for [x, y] in &self.points {
            for number in [*x, *y, 0.0] {
                bytes.extend_from_slice(&number.to_be_bytes());
            }
        }
        let (cells, data) = match self.ends {
            1 => ("VERTICES", "POINT_DATA"),
            _ => ("LINES", "CELL_DATA"),
        };
        let size = (self.ends + 1) * count;
        line(&mut bytes, format!("\n{cells} {count} {size}"));
        for cell in 0..count {
            let ends = (0..self.ends).map(|end| cell * self.ends + end);
            for number in std::iter::once(self.ends).chain(ends) {
                bytes.extend_from_slice(&(number as i32).to_be_bytes());
            }
        }
        line(&mut bytes, format!("\n{data} {count}"));
        line(&mut bytes, format!("FIELD values {}", self.values.len()));
        for values in &self.values {
            let (kind, raw): (_, Vec<u8>) = match &values.numbers {
                Numbers::Real(numbers) => (
                    "double",
                    numbers.iter().flat_map(|x| x.to_be_bytes()).collect(),
                ),
                Numbers::Whole(numbers) => (
                    "unsigned_int",
                    numbers.iter().flat_map(|x| x.to_be_bytes()).collect(),
                ),
            };
            let (name, width) = (values.name, values.width);
            line(&mut bytes, format!("{name} {width} {count} {kind}"));
            bytes.extend_from_slice(&raw);
            bytes.push(b'\n');
        }
        bytes
    }
}

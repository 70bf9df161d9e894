//! Reading a journal back.

use super::{Event, EventKind, FORMAT, Journal, Moment, TITLE, quotes, without_mark};

/// A line that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {message}; {remedy}")]
pub struct JournalError {
    /// Line, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub remedy: String,
}

/// Where in the file we are.
enum Part {
    Title,
    Header,
    Preset(Vec<String>),
    Events,
}

pub(super) fn journal(text: &str) -> Result<Journal, JournalError> {
    let mut reader = Reader {
        journal: Journal::default(),
        part: Part::Title,
        line: 0,
        seen: Vec::new(),
        converted: false,
    };
    for line in without_mark(text).split_inclusive('\n') {
        reader.line += 1;
        // A line without its end may lack more than that: `@12` could have been `@1200`.
        if let Some(line) = line.strip_suffix('\n') {
            reader.take(line)?;
        } else {
            reader.journal.cut = true;
        }
    }
    if let Part::Events = reader.part {
        return Ok(reader.journal);
    }
    reader.line += 1;
    Err(reader.error(
        "the journal ends before its preset does",
        "it cannot be replayed: run the preset itself",
    ))
}

/// Whether a command could be taken for another kind of event.
pub(super) fn is_reserved(command: &str) -> bool {
    let word = command.split(' ').next().unwrap_or_default();
    ["stage", "end", "fault", "back"].contains(&word) || word.starts_with(':')
}

struct Reader {
    journal: Journal,
    part: Part,
    line: usize,
    /// Keys of the header so far.
    seen: Vec<String>,
    /// Whether some editor or transfer has given every line a carriage return.
    converted: bool,
}

impl Reader {
    fn take(&mut self, raw: &str) -> Result<(), JournalError> {
        let line = raw.strip_suffix('\r').unwrap_or(raw);
        match &mut self.part {
            Part::Title => {
                self.title(line)?;
                self.converted = line != raw;
                self.part = Part::Header;
            }
            Part::Header if line == "begin preset" => {
                self.check_header()?;
                self.part = Part::Preset(Vec::new());
            }
            Part::Header => self.header(line)?,
            Part::Preset(lines) if line == "end preset" => {
                self.journal.preset_text = lines.join("\n");
                self.part = Part::Events;
            }
            Part::Preset(lines) => {
                // Otherwise a carriage return is the preset's own.
                let line = if self.converted { line } else { raw };
                match line.strip_prefix("| ") {
                    Some(text) => lines.push(text.to_owned()),
                    None if line == "|" => lines.push(String::new()),
                    None => {
                        return Err(self.error(
                            "a line of the preset does not start with `| `",
                            "lines of the preset do, and `end preset` closes it",
                        ));
                    }
                }
            }
            Part::Events if line.is_empty() => {}
            Part::Events => {
                if self.journal.is_complete() {
                    return Err(self.error("something follows the end", "`@CYCLE end` comes last"));
                }
                let event = self.event(line)?;
                self.journal.events.push(event);
            }
        }
        Ok(())
    }

    fn title(&self, line: &str) -> Result<(), JournalError> {
        let format = line.strip_prefix(TITLE).map(str::trim);
        match format {
            Some(FORMAT) => Ok(()),
            Some(format) => Err(self.error(
                format!(
                    "the journal has format `{format}`, and this program reads format {FORMAT}"
                ),
                "replay it with the version of ballast that wrote it",
            )),
            None => Err(self.error(
                "this is no journal",
                format!("its first line is `{TITLE} {FORMAT}`"),
            )),
        }
    }

    fn header(&mut self, line: &str) -> Result<(), JournalError> {
        if line.is_empty() {
            return Ok(());
        }
        let (key, value) = line.split_once(' ').unwrap_or((line, ""));
        if key != "set" && self.seen.iter().any(|seen| seen == key) {
            return Err(self.error(
                format!("`{key}` is given twice"),
                "leave one of the two lines out",
            ));
        }
        match key {
            "program" => self.journal.program = self.text(key, value)?,
            "preset" => self.journal.preset_name = self.text(key, value)?,
            "set" => self.journal.overrides.push(self.text(key, value)?),
            "seed" => {
                self.journal.seed = Some(whole_number(value).ok_or_else(|| {
                    self.error(format!("`{value}` is no seed"), "a seed is a whole number")
                })?);
            }
            _ => {
                return Err(self.error(
                    format!("`{key}` is not known here"),
                    "program, preset, seed and set come first, then `begin preset`",
                ));
            }
        }
        self.seen.push(key.to_owned());
        Ok(())
    }

    fn text(&self, key: &str, value: &str) -> Result<String, JournalError> {
        quotes::unquoted(value).map_err(|message| {
            self.error(format!("{key}: {message}"), format!("write {key} \"...\""))
        })
    }

    fn check_header(&self) -> Result<(), JournalError> {
        let missing = ["program", "preset"]
            .into_iter()
            .find(|key| !self.seen.iter().any(|seen| seen == key));
        missing.map_or(Ok(()), |key| {
            Err(self.error(
                format!("`{key}` is missing"),
                format!("add a line {key} \"...\" above"),
            ))
        })
    }

    fn event(&self, line: &str) -> Result<Event, JournalError> {
        let form = "write @CYCLE and a command, for instance `@100 friction 0.3`";
        let event = line.strip_prefix('@').and_then(|line| line.split_once(' '));
        let Some((cycle, what)) = event else {
            return Err(self.error("this is no event", form));
        };
        let Some(cycle) = whole_number(cycle) else {
            return Err(self.error(format!("`{cycle}` is no cycle number"), form));
        };
        let text = |quoted: &str| {
            if quoted.is_empty() {
                return Err(self.error("the end of the line is missing", form));
            }
            quotes::unquoted_if_quoted(quoted)
                .map_err(|message| self.error(message, "write \\\" for a mark within the quotes"))
        };
        let kind = match what.split_once(' ').unwrap_or((what, "")) {
            ("end", "") => EventKind::End,
            ("stage", name) => EventKind::Stage(text(name)?),
            (":", command) => EventKind::Staged(text(command)?),
            ("fault", why) => EventKind::Fault(text(why)?),
            ("back", what) => {
                let mut words = what.splitn(3, ' ');
                let mut number = || words.next().and_then(whole_number);
                let (Some(cycle), Some(events)) = (number(), number()) else {
                    return Err(self.error(
                        "it does not say where to go back to",
                        "write @CYCLE back CYCLE EVENTS FILE, with the number of events before it",
                    ));
                };
                EventKind::Back {
                    to: Moment {
                        cycle,
                        events: usize::try_from(events).unwrap_or(usize::MAX),
                    },
                    file: text(words.next().unwrap_or_default())?,
                }
            }
            _ => EventKind::Typed(text(what)?),
        };
        Ok(Event { cycle, kind })
    }

    fn error(&self, message: impl Into<String>, remedy: impl Into<String>) -> JournalError {
        JournalError {
            line: self.line,
            message: message.into(),
            remedy: remedy.into(),
        }
    }
}

/// Digits only: `+5` and ` 5` are typing errors.
fn whole_number(text: &str) -> Option<u64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "ballast journal 1\nprogram \"0.1.0\"\npreset \"x\"\n";

    #[test]
    fn wrong_lines_are_named_with_a_remedy() {
        let preset = format!("{HEADER}begin preset\n| a\nend preset\n");
        for (text, line, hint) in [
            (String::new(), 1, "ends before its preset"),
            ("title = 1\n".into(), 1, "no journal"),
            ("ballast journal 2\n".into(), 1, "format `2`"),
            (
                "ballast journal 1\nbegin preset\n".into(),
                2,
                "`program` is missing",
            ),
            (format!("{HEADER}seed -1\n"), 4, "`-1` is no seed"),
            (format!("{HEADER}preset \"y\"\n"), 4, "given twice"),
            (
                format!("{HEADER}preste \"y\"\n"),
                4,
                "`preste` is not known",
            ),
            (format!("{HEADER}set x\n"), 4, "quotation mark"),
            (
                format!("{HEADER}begin preset\nno bar\n"),
                5,
                "does not start with",
            ),
            (
                format!("{HEADER}begin preset\n| a\n"),
                6,
                "ends before its preset",
            ),
            (format!("{preset}friction 0.3\n"), 7, "no event"),
            (
                format!("{preset}@x friction 0.3\n"),
                7,
                "`x` is no cycle number",
            ),
            (
                format!("{preset}@99999999999999999999 go\n"),
                7,
                "no cycle number",
            ),
            (format!("{preset}@1 stage\n"), 7, "missing"),
            (format!("{preset}@1 end\n@2 go\n"), 8, "follows the end"),
            (format!("{preset}@1 \"go\n"), 7, "closing"),
            (format!("{preset}@1 fault\n"), 7, "missing"),
            (format!("{preset}@1 back 0 x a\n"), 7, "where to go back"),
            (format!("{preset}@1 back 0 2\n"), 7, "missing"),
        ] {
            let error = journal(&text).unwrap_err();
            assert_eq!(error.line, line, "{text}{error}");
            assert!(error.to_string().contains(hint), "{text}{error}");
            assert!(!error.remedy.is_empty());
        }
    }

    #[test]
    fn an_unfinished_line_is_dropped_and_said() {
        let text = format!("{HEADER}begin preset\nend preset\n@1 go\n@12");
        let read = journal(&text).unwrap();
        assert!(read.cut && !read.is_complete());
        assert_eq!(read.events.len(), 1);
    }
}

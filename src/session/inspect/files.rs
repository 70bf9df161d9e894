//! Files of a followed contact.

use std::path::Path;

use super::{picture, table};
use crate::language::command::ContactFile;
use crate::record::whole_file;
use crate::session::{Refusal, Reply, Session};

impl Session {
    /// Writes the followed contact.
    pub(in crate::session) fn export_contact(
        &self,
        what: ContactFile,
        file: &str,
    ) -> Result<Reply, Refusal> {
        let inspection = self.inspected()?;
        let moments = inspection.trace.len();
        let (bytes, content) = match what {
            ContactFile::Path => {
                let table = table::path(&inspection);
                (table.bytes().to_vec(), format!("{moments} moments"))
            }
            ContactFile::Traction => {
                let Some(traction) = &inspection.traction else {
                    return Err(no_traction(&inspection));
                };
                let table = table::traction(&inspection, traction);
                (table.bytes().to_vec(), "traction".to_owned())
            }
            ContactFile::Picture => {
                let svg = picture::svg(&inspection).map_err(|error| {
                    Refusal::new(
                        format!("the picture cannot be drawn: {error}"),
                        "`export path FILE` writes the numbers",
                    )
                })?;
                (svg.into_bytes(), format!("{moments} moments"))
            }
        };
        whole_file::write(Path::new(file), &bytes)?;
        let name = &inspection.name;
        Ok(Reply::line(format!(
            "{content} of contact {name} in {file}"
        )))
    }
}

fn no_traction(inspection: &super::Inspection) -> Refusal {
    let name = &inspection.name;
    if inspection.state == "apart" {
        return Refusal::new(
            format!("contact {name} is apart: there is no traction"),
            "run until it touches",
        );
    }
    let remedy = if inspection.shears() {
        "law mindlin-deresiewicz-exact knows it at any time"
    } else {
        "it has no friction: give it some"
    };
    let law = inspection.law;
    let message = format!("the traction of contact {name} is not known to law {law} in this state");
    Refusal::new(message, remedy)
}

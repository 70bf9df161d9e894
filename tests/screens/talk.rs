//! What is typed and answered: it can be read to its end, the screen's own words are like commands, and
//! leaving asks when it has to.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use ballast::session::worker::{Order, Report};
use ballast::session::{Refusal, Reply};
use ballast::tui::app::{App, Effect, Overlay, Said};
use ballast::tui::panes::PaneId;

use crate::example::{LOOK, app};
use crate::{drawn, text};

const FAILURE: &str = "cycle 14820: the centre of particle 1 went through wall left; reduce frac, \
     the speed, or stiffen the contact; to go back to cycle 14000: `restore \
     /home/someone/.local/state/ballast/runs/two-discs-1700000000000-1234/run.ballast`";

/// Words of a screen, without the frames of its panes.
fn words(app: &mut App, (width, height): (u16, u16)) -> String {
    let lines = text(&drawn(app, width, height));
    let plain = lines.replace(['│', '─', '┌', '┐', '└', '┘'], " ");
    plain.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn press(app: &mut App, code: KeyCode) -> Effect {
    app.key(KeyEvent::new(code, KeyModifiers::NONE))
}

/// Types a line, and leaves the prompt.
fn line(app: &mut App, line: &str) -> Effect {
    app.prompt.open_with(line);
    let effect = press(app, KeyCode::Enter);
    press(app, KeyCode::Esc);
    effect
}

fn answered(app: &mut App, line: &str, reply: Result<Reply, Refusal>) {
    let line = line.to_owned();
    app.take_report(Report::Said { line, reply });
}

fn reply(lines: &[&str]) -> Reply {
    Reply {
        lines: lines.iter().map(|line| (*line).to_owned()).collect(),
        request: None,
    }
}

#[test]
fn failures_are_read_to_their_end_at_every_usual_size() {
    for size in [(80, 24), (100, 30), (60, 15), (120, 40), (200, 60)] {
        let mut app = app(LOOK);
        drawn(&mut app, size.0, size.1);
        app.take_report(Report::Failed(FAILURE.to_owned()));
        let words = words(&mut app, size);
        for part in ["stiffen", "14000:", "`restore"] {
            assert!(words.contains(part), "{size:?}: {part}: {words}");
        }
        // Beside other panes its lines stand apart.
        if size.0 <= 100 {
            let part = "go back to cycle 14000: `restore";
            assert!(words.contains(part), "{size:?}: {words}");
            assert!(words.replace(' ', "").contains("run.ballast`"), "{words}");
        }
    }
}

#[test]
fn refusals_that_do_not_fit_are_read_from_their_beginning() {
    let mut app = app(LOOK);
    drawn(&mut app, 20, 5);
    let refusal = Refusal::new(FAILURE, "or not");
    answered(&mut app, "go", Err(refusal));
    assert_eq!(app.zoomed, Some(PaneId::Dialogue));
    let lines = text(&drawn(&mut app, 20, 5));
    assert!(lines.contains("! cycle 14820: the"), "{lines}");
}

#[test]
fn the_dialogue_stops_at_its_top() {
    let mut app = app(LOOK);
    app.zoomed = Some(PaneId::Dialogue);
    (0..100).for_each(|k| app.say(Said::Answer(format!("line {k} {}", "x".repeat(70)))));
    drawn(&mut app, 80, 24);
    (0..30).for_each(|_| {
        press(&mut app, KeyCode::PageUp);
    });
    let lines = text(&drawn(&mut app, 80, 24));
    assert!(lines.contains("> friction 0.3"), "{lines}");
    assert!(lines.contains("line 13 "), "a full page: {lines}");
    press(&mut app, KeyCode::PageDown);
    let next = text(&drawn(&mut app, 80, 24));
    assert!(next.contains("line 13 "), "pages overlap: {next}");
    assert!(!next.contains("line 12 "), "by a page: {next}");
}

#[test]
fn words_of_the_screen_are_explained_echoed_and_refused_like_commands() {
    for (typed, says) in [
        ("help pane", "pane NAME"),
        ("? loa", "starts a preset"),
        ("pane", "there is chart, contact, rose"),
        ("pane nonsense", "`nonsense` is no pane; there is chart"),
        ("pane r", ""),
        ("pane c", "`c` could be `chart` or `contact`"),
        ("pane assembly", "the assembly keeps its place"),
        ("pnae mohr", "`pnae` is no command; did you mean `pane`?"),
        ("pa", "`pa` could be `pace`, `pane`, `particle` or `pause`"),
        (
            "pace",
            "a number of cycles per second is missing; usage: pace N | max",
        ),
        ("pace fast", "`fast` is no number of cycles per second"),
        ("set kbps 20", "the screen uses 20 kB/s at most"),
        (
            "set volume 3",
            "`volume 3` is no number of kB/s; usage: set kbps N | max",
        ),
        ("load", "`load` needs a preset"),
        ("load nothing", "there is no preset `nothing`; none of the"),
    ] {
        let mut app = app(LOOK);
        drawn(&mut app, 120, 40);
        assert!(matches!(line(&mut app, typed), Effect::None), "{typed}");
        let mut said = app.dialogue.iter().skip(5);
        assert_eq!(said.next(), Some(&Said::Line(typed.to_owned())), "{typed}");
        let words = words(&mut app, (120, 40));
        assert!(words.contains(says), "{typed}: {words}");
    }
}

#[test]
fn words_of_the_screen_do_what_they_say() {
    let mut app = app(LOOK);
    for (typed, pace) in [
        ("pace 200", Some(200.0)),
        ("pace max", None),
        ("pace 0", None),
    ] {
        let Effect::Order(Order::Pace(given)) = line(&mut app, typed) else {
            panic!("{typed} orders no pace");
        };
        assert_eq!(given, pace, "{typed}");
    }
    assert!(matches!(
        line(&mut app, "load disc-pile"),
        Effect::Load("disc-pile")
    ));
    line(&mut app, "set kbps 5");
    assert_eq!(app.link.budget, Some(5e3));
    line(&mut app, "set kbps 0");
    assert_eq!(app.link.budget, None);
    for command in ["se stress 1", "friction 0.3", "nonsense", "help solve"] {
        assert!(
            matches!(line(&mut app, command), Effect::Order(Order::Line(_))),
            "{command}"
        );
    }
}

#[test]
fn the_list_of_commands_tells_of_the_words_of_the_screen() {
    let mut app = app(LOOK);
    answered(&mut app, "help", Ok(reply(&["create  makes a particle"])));
    let words = words(&mut app, (120, 40));
    assert!(words.contains("pace sets how many cycles"), "{words}");
}

#[test]
fn leaving_asks_unless_the_history_was_exported_or_the_state_saved() {
    for (typed, asks) in [
        ("exp csv f.csv", false),
        ("export csv f.csv", false),
        (":export csv f.csv", false),
        ("sa f.ballast", false),
        ("export svg mohr f.svg", true),
        ("export vtk particles f.vtk", true),
        ("print step", true),
    ] {
        let mut app = app(LOOK);
        answered(&mut app, typed, Ok(reply(&["148 rows in f.csv"])));
        let leaves = matches!(press(&mut app, KeyCode::Char('q')), Effect::Quit);
        assert_eq!(!leaves, asks, "{typed}");
        assert_eq!(app.overlay == Some(Overlay::Quit), asks, "{typed}");
    }
}

#[test]
fn who_goes_back_has_exported_no_more_than_what_is_left() {
    let mut app = app(LOOK);
    answered(&mut app, "export csv f.csv", Ok(reply(&[])));
    for cycle in [100, 200] {
        let mut frame = crate::example::frame();
        (frame.cycle, frame.restarted) = (cycle, false);
        app.take_frame(Box::new(frame));
    }
    assert!(matches!(press(&mut app, KeyCode::Char('q')), Effect::None));
}

#[test]
fn another_run_keeps_its_files_elsewhere() {
    let mut app = app(LOOK);
    app.keep_in("/home/someone/runs/0002".into());
    assert_eq!(app.folder, "/home/someone/runs/0002");
    let last = app.dialogue.last();
    let Some(Said::Notice(text)) = last else {
        panic!("{last:?}");
    };
    assert!(text.ends_with("is kept in /home/someone/.local/state/ballast/runs/0001"));
}

/// What is pasted is executed line by line, as if typed behind what stands there; remarks are passed over, and
/// a line without an end waits.
#[test]
fn pasted_lines_stay_apart() {
    for ends in ["\r", "\n", "\r\n"] {
        let mut app = app(LOOK);
        app.prompt.open_with("pri");
        let text = ["nt energy", "", "# a remark", "print step", "cyc"].join(ends);
        let orders = app.paste(&text);
        let lines: Vec<&str> = orders
            .iter()
            .map(|effect| match effect {
                Effect::Order(Order::Line(line)) => line.as_str(),
                _ => "no line",
            })
            .collect();
        assert_eq!(lines, ["print energy", "print step"]);
        assert_eq!(app.prompt.text(), "cyc");
    }
}

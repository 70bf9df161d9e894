//! How lines read, and how their mistakes do.

use ballast::language::Command;

#[test]
fn prefixes_and_case_are_as_good_as_the_words() {
    for (short, long) in [
        ("CYC 1000", "cycle 1000"),
        ("PRI CON", "print contacts"),
        ("pri con 1-3", "print contacts 1-3"),
        (
            "cre at 0 0 r 1 mat Glass vel 1 2",
            "create at 0 0 radius 1 material Glass velocity 1 2",
        ),
        ("WALL Left VEL 1e-3 0", "wall Left velocity 0.001 0"),
        (
            "sol unt KINETIC < 1_0 AND cycle > 5 ma 100",
            "solve until kinetic < 10 and cycle > 5 max 100",
        ),
        ("solve max 9 until(cycle>3)", "solve until cycle > 3 max 9"),
        ("solve until (cycle>3)max 9", "solve until cycle > 3 max 9"),
        (
            "solve until max(1, 2) > 1 max 9",
            "solve until max(1, 2) > 1 max 9",
        ),
        ("type steel dens 7_800", "property steel density 7800"),
        ("? SOL", "help solve"),
        ("q!", "quit!"),
        ("zero vel", "zero"),
        ("step", "step 1"),
        ("inspect contact 2-1", "inspect contact 1-2"),
        (
            "history col kinetic dt ,fracc",
            "history columns kinetic,dt,fracc",
        ),
        ("par 3 fix spin x", "particle 3 fix x spin"),
        ("save \"a b\"#c", "save \"a b\""),
        (r#"save "C:\new runs\x""#, r#"save "C:\\new runs\\x""#),
        ("gravity -0 -0.0", "gravity 0 0"),
    ] {
        let command = Command::parse(short).unwrap_or_else(|m| panic!("{short}: {m}"));
        assert_eq!(command.to_string(), long);
    }
}

#[test]
fn what_a_command_does_is_known_without_executing_it() {
    for (line, changes, runs) in [
        ("friction 0.3", true, false),
        ("restore a", true, false),
        ("cycle 5", false, true),
        ("solve", false, true),
        ("step", false, true),
        ("go", false, true),
        ("pause", false, false),
        ("history every 5", false, false),
        ("print all", false, false),
    ] {
        let command = Command::parse(line).unwrap();
        assert_eq!(command.changes_world(), changes, "{line}");
        assert_eq!(command.runs_cycles(), runs, "{line}");
    }
}

/// Lines, what their mistake says and the part of the line it points at.
const MISTAKES: &[(&str, &str, &str)] = &[
    (
        "",
        "the line is empty; write a command, or `help` for the list",
        "",
    ),
    (
        "  # later",
        "the line is empty; write a command, or `help` for the list",
        "",
    ),
    (
        "cylce 100",
        "`cylce` is no command; did you mean `cycle`?",
        "cylce",
    ),
    ("xyzzy", "`xyzzy` is no command; `help` lists them", "xyzzy"),
    (
        "p balls",
        "`p` could be `particle`, `pause`, `print` or `property`; write more of it",
        "p",
    ),
    (
        "re a",
        "`re` could be `reference` or `restore`; write more of it",
        "re",
    ),
    (
        "print b",
        "`b` could be `balls` or `boundary`; write more of it",
        "b",
    ),
    (
        "cycle",
        "the line ends where the number of cycles is expected; usage: cycle N",
        "",
    ),
    (
        "cycle ten",
        "`ten` is no number where the number of cycles is expected; usage: cycle N",
        "ten",
    ),
    (
        "cycle 0",
        "the number of cycles is `0`; it must be a whole number from 1",
        "0",
    ),
    (
        "cycle 1.5",
        "the number of cycles is `1.5`; it must be a whole number from 1",
        "1.5",
    ),
    (
        "cycle 1e300",
        "the number of cycles is `1e300`; it must be at most 9007199254740992",
        "1e300",
    ),
    (
        "cycle 10 20",
        "`20` is one word too many; usage: cycle N",
        "20",
    ),
    (
        "zero 1",
        "`1` stands where `velocities` is expected; usage: zero [velocities]",
        "1",
    ),
    (
        "create at 0 0",
        "the line ends where `radius` is expected; \
         usage: create at X Y radius R [material M] [velocity VX VY] [spin W]",
        "",
    ),
    (
        "create at 0 0 radius -1",
        "the radius is `-1`; it must be greater than 0",
        "-1",
    ),
    (
        "create at 0 0 radius 1 spin 2 spin 3",
        "`spin` stands where `material` or `velocity` is expected; \
         usage: create at X Y radius R [material M] [velocity VX VY] [spin W]",
        "spin",
    ),
    (
        "create at 0 0 radius nan",
        "`nan` is no number where the radius is expected; \
         usage: create at X Y radius R [material M] [velocity VX VY] [spin W]",
        "nan",
    ),
    ("frac 0", "frac is `0`; it must be greater than 0", "0"),
    (
        "frac 1e999",
        "frac is `1e999`; it must be at most about 1.8e308",
        "1e999",
    ),
    (
        "friction -0.1",
        "the coefficient is `-0.1`; it must be 0 or greater",
        "-0.1",
    ),
    (
        "con1 1.01",
        "con1 is `1.01`; it must be between 0 and 1",
        "1.01",
    ),
    (
        "property steel poisson 0.6",
        "poisson is `0.6`; it must be above -1 and at most 0.5",
        "0.6",
    ),
    (
        "property steel densty 3",
        "`densty` is not known here; did you mean `density`?",
        "densty",
    ),
    (
        "wall 3rd spin 1",
        "`3rd` cannot name a wall; a name is a letter followed by letters, digits and `_`",
        "3rd",
    ),
    (
        "wall a from 0 0 to 0 0",
        "the wall begins and ends at the same point; walls have a length",
        "0 0",
    ),
    ("delete 7-3", "`7-3` runs backwards; write 3-7", "7-3"),
    (
        "delete 0",
        "`0` is no particle number; particles are numbered from 1 to at most 4294967295",
        "0",
    ),
    (
        "delete one",
        "`one` stands where a particle number is expected; usage: delete I|I-J",
        "one",
    ),
    (
        "inspect contact 4-4",
        "`4-4` names one particle twice; a contact joins two bodies",
        "4-4",
    ),
    (
        "inspect contact 4",
        "`4` stands where a contact, I-J or I-WALL, is expected; usage: inspect contact I-J|I-WALL | off",
        "4",
    ),
    (
        "history columns kinetc",
        "`kinetc` is no column; did you mean `kinetic`?",
        "kinetc",
    ),
    (
        "history columns dt,dt",
        "`dt` is listed twice; name each column once",
        "dt",
    ),
    (
        "history columns",
        "the line ends where a column is expected; usage: history [every N | columns NAME,NAME,...]",
        "",
    ),
    (
        "solve until kinetic",
        "`kinetic` is a number where a condition is needed; \
         compare it with something, for instance `> 0`",
        "kinetic",
    ),
    (
        "solve until sin_phy and 3",
        "`sin_phy` is no column; did you mean `sin_phi`?",
        "sin_phy",
    ),
    (
        "solve ratio 1 until cycle > 3",
        "`until` stands where `max` is expected; usage: solve [ratio R | until EXPRESSION] [max N]",
        "until",
    ),
    (
        "solve until cycle > 3 then",
        "`then` stands where `max` is expected; usage: solve [ratio R | until EXPRESSION] [max N]",
        "then",
    ),
    ("save \"a b", "this quote is never closed; add `\"`", "\""),
    (
        "save",
        "the line ends where a file name is expected; usage: save FILE",
        "",
    ),
    (
        "save \"\"",
        "`` stands where a file name is expected; usage: save FILE",
        "\"\"",
    ),
    (
        "gravity down",
        "`down` stands where `none` or `towards` is expected; usage: gravity GX GY | none | towards X Y G",
        "down",
    ),
    (
        "help cylce",
        "`cylce` is no command; did you mean `cycle`?",
        "cylce",
    ),
    (
        "cycle 1\ncycle 2",
        "the text has several lines; write one command in a line",
        "cycle 1\ncycle 2",
    ),
];

#[test]
fn mistakes_read_as_they_are_meant_to() {
    for (line, text, at) in MISTAKES {
        let mistake = Command::parse(line).unwrap_err();
        assert_eq!(mistake.to_string(), *text);
        assert_eq!(&line[mistake.span], *at, "{line}");
    }
}

#[test]
fn noise_of_megabytes_is_refused_quickly_and_briefly() {
    for unit in [
        "x",
        "history columns ",
        "(",
        "-",
        "solve until ",
        "\"",
        "1 ",
        "é",
    ] {
        for verb in ["", "solve until ", "history columns ", "create at "] {
            let line = format!("{verb}{}", unit.repeat(1 << 20));
            let mistake = Command::parse(&line).unwrap_err();
            assert!(
                mistake.to_string().len() < 300,
                "{verb}{unit}: {}",
                mistake.to_string().len()
            );
        }
    }
}

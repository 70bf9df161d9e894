//! A followed contact as a picture: its loops, its path between the friction limits, and the
//! traction inside it.

use std::error::Error;

use plotters::prelude::*;

use super::{Inspection, Moment};
use crate::engine::contact::traction::{Traction, Zone};
use crate::session::figure::figure;
use crate::session::pictures::plate::{
    Area, Chart, Drawn, FAINT, FONT, LIMIT, PATH, SMALL, around, chart, plate, tick,
};

/// Width and height [pixels].
const SIZE: (u32, u32) = (1000, 820);

/// Orange, with the others of the plate (Okabe & Ito).
const SLIP: RGBColor = RGBColor(230, 159, 0);

/// Points of the profile.
const STEPS: u32 = 400;

/// Ends of its axis: above the curves is room for the legend.
const LOW: f64 = 1.15;
const HIGH: f64 = 1.85;

/// The picture as SVG.
pub(super) fn svg(inspection: &Inspection) -> Result<String, Box<dyn Error>> {
    plate(SIZE, &title(inspection), |area| {
        let parts = area.split_evenly((2, 2));
        loops(&parts[0], inspection)?;
        between_limits(&parts[1], inspection)?;
        normal(&parts[2], inspection)?;
        profile(&parts[3], inspection)
    })
}

fn title(inspection: &Inspection) -> String {
    let (since, stride) = inspection.since;
    let last = inspection.trace.last().map_or(since, |moment| moment.cycle);
    let every = match stride {
        1 => String::new(),
        stride => format!(", every {stride} cycles"),
    };
    format!(
        "contact {}, {}: cycles {since} to {last}{every}, {}",
        inspection.name, inspection.law, inspection.state
    )
}

/// The path in a plane, touch by touch, and a mark where it is now.
fn path(
    chart: &mut Chart<'_, '_>,
    inspection: &Inspection,
    at: fn(&Moment) -> (f64, f64),
) -> Drawn {
    let touches = inspection.trace.chunk_by(|a, b| a.touch == b.touch);
    for touch in touches {
        chart.draw_series(LineSeries::new(touch.iter().map(at), PATH.stroke_width(2)))?;
    }
    if let Some(now) = inspection.trace.last() {
        chart.draw_series(std::iter::once(Circle::new(at(now), 4, PATH.filled())))?;
    }
    Ok(())
}

fn legend<'a, 'b: 'a>(chart: &mut Chart<'a, 'b>, place: SeriesLabelPosition) -> Drawn {
    chart
        .configure_series_labels()
        .position(place)
        .background_style(WHITE.mix(0.85))
        .border_style(FAINT)
        .label_font((FONT, SMALL))
        .draw()?;
    Ok(())
}

fn loops(area: &Area<'_>, inspection: &Inspection) -> Drawn {
    let trace = &inspection.trace;
    let ranges = (
        around(trace.iter().map(|m| m.delta)),
        around(trace.iter().map(|m| m.t)),
    );
    let names = ("tangential displacement [m]", "T [N]");
    let mut chart = chart(area, "tangential force over displacement", ranges, names)?;
    path(&mut chart, inspection, |m| (m.delta, m.t))
}

fn between_limits(area: &Area<'_>, inspection: &Inspection) -> Drawn {
    let trace = &inspection.trace;
    let n = around(trace.iter().map(|m| m.n));
    let limit = |n: f64| inspection.friction * n.max(0.0) + inspection.cohesion;
    let most = trace.iter().map(|m| limit(m.n).max(m.t.abs()));
    let most = around(most).end;
    let t = -most..most;
    let names = ("N [N]", "T [N]");
    let mut chart = chart(
        area,
        "path between the friction limits",
        (n.clone(), t),
        names,
    )?;
    if inspection.shears() {
        let start = n.start.max(0.0);
        for sign in [1.0, -1.0] {
            let ends = [start, n.end].map(|n| (n, sign * limit(n)));
            let series = LineSeries::new(ends, LIMIT.stroke_width(1));
            let drawn = chart.draw_series(series)?;
            if sign > 0.0 {
                drawn
                    .label(format!("±μN, μ = {}", figure(inspection.friction)))
                    .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], LIMIT));
            }
        }
    }
    path(&mut chart, inspection, |m| (m.n, m.t))?;
    // The limits leave that corner free.
    legend(&mut chart, SeriesLabelPosition::UpperLeft)
}

fn normal(area: &Area<'_>, inspection: &Inspection) -> Drawn {
    let trace = &inspection.trace;
    let ranges = (
        around(trace.iter().map(|m| m.alpha)),
        around(trace.iter().map(|m| m.n)),
    );
    let names = ("overlap [m]", "N [N]");
    let mut chart = chart(area, "normal force over overlap", ranges, names)?;
    path(&mut chart, inspection, |m| (m.alpha, m.n))
}

fn profile(area: &Area<'_>, inspection: &Inspection) -> Drawn {
    let Some(traction) = &inspection.traction else {
        let text = if inspection.state == "apart" {
            "apart: no traction"
        } else {
            "traction not known to this law in this state"
        };
        let style = (FONT, 16).into_font();
        area.draw(&Text::new(text, (90, 120), style))?;
        return Ok(());
    };
    let c = traction.stick_ratio();
    let title = format!("traction inside the contact, now: c/a = {}", tick(c, 1.0));
    let names = ("r/a", "q / (μ p0)");
    let mut chart = chart(area, &title, (-1.05..1.05, -LOW..HIGH), names)?;
    // The annulus that slips, behind everything else.
    if c < 1.0 {
        let fill = SLIP.mix(0.25).filled();
        let sides = [[-1.0, -c], [c, 1.0]];
        let bands = sides.map(|[from, to]| Rectangle::new([(from, -LOW), (to, LOW)], fill));
        chart
            .draw_series(bands)?
            .label(slip_name(traction))
            .legend(move |(x, y)| Rectangle::new([(x, y - 5), (x + 18, y + 5)], fill));
    }
    let over = |height: fn(&Traction, f64) -> f64, sign: f64| {
        (-i64::from(STEPS)..=i64::from(STEPS)).map(move |k| {
            let r = k as f64 / f64::from(STEPS);
            (r, sign * height(traction, r.abs()))
        })
    };
    for sign in [1.0, -1.0] {
        let limit = over(|_, r| Traction::pressure(r), sign);
        let drawn = chart.draw_series(LineSeries::new(limit, LIMIT.stroke_width(1)))?;
        if sign > 0.0 {
            drawn
                .label("±μp, the limit")
                .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], LIMIT));
        }
    }
    chart
        .draw_series(LineSeries::new(
            over(Traction::at, 1.0),
            PATH.stroke_width(2),
        ))?
        .label("q")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], PATH.stroke_width(2)));
    legend(&mut chart, SeriesLabelPosition::UpperRight)
}

fn slip_name(traction: &Traction) -> &'static str {
    match traction.zone(0.999_999) {
        Zone::SlipBackward => "slips along -t",
        _ => "slips along +t",
    }
}

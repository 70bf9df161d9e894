//! The grading of the thesis, a third of it.

/// 200 spheres of five sizes without friction, in a region.
pub(crate) fn grains(region: &str) -> String {
    format!(
        r#"
        [model]
        law = "hertz-mindlin"
        frac = 0.2
        [damping]
        contact = 0.1
        [material.glass]
        density = 2650
        young = 70e9
        poisson = 0.25
        [[generate]]
        in = {region}
        material = "glass"
        grading = [
          {{ radius = 0.92e-3, count = 10 }},
          {{ radius = 0.76e-3, count = 46 }},
          {{ radius = 0.61e-3, count = 57 }},
          {{ radius = 0.46e-3, count = 77 }},
          {{ radius = 0.31e-3, count = 10 }},
        ]
        "#
    )
}

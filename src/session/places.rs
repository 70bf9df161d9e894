//! Where something is measured: in a region of the scene, or in a place that has no name.

use std::borrow::Cow;

use crate::language::command::Where;
use crate::measure::region::Region;
use crate::measure::regional::Regional;
use crate::measure::sample::Sample;

/// What has to be measured for a place: the regions of the scene, or that place alone.
pub(super) fn regions_of<'a>(place: &Where, regions: &'a [Region]) -> Cow<'a, [Region]> {
    match place {
        Where::Default | Where::Region(_) => Cow::Borrowed(regions),
        Where::Here(place) => Cow::Owned(vec![Region {
            name: place.to_string(),
            shape: place.shape(),
        }]),
    }
}

/// The place in a sample of these regions.
pub(super) fn region_at<'a, 's>(sample: &'a Sample<'s>, place: &Where) -> &'a Regional<'s> {
    let named = match place {
        Where::Region(name) => sample.region(name),
        // The first region.
        Where::Default | Where::Here(_) => None,
    };
    named.unwrap_or_else(|| sample.regional())
}

//! The height fields: how high each kind of roof is over each cell of the plan, outside of the footprint as well.

use super::ends::{cross_gable_ends, gable_ends};
use super::profile::{GAMBREL, MANSARD, Profile, Surface};
use super::{Kind, Site};
use crate::space::{Depths, Footprint, Spot};

pub type Heights = Box<dyn Fn(Spot) -> Surface>;

/// Steeper roofs than this are towers.
const STEEPEST: f64 = 64.0;

/// The field of a roof. Its pitch, if it is given, makes the scope's height a limit; else that height is the
/// ridge's.
pub fn surface(kind: Kind, pitch: Option<f64>, site: &Site) -> Heights {
    let pitch = pitch.filter(|pitch| !pitch.is_nan()).map(|pitch| pitch.clamp(0.0, STEEPEST));
    let field = match kind {
        Kind::Gable => gabled(Profile::Straight, pitch, site),
        Kind::Gambrel => gabled(GAMBREL, pitch, site),
        Kind::Hip => hipped(Profile::Straight, pitch, site),
        Kind::Mansard => hipped(MANSARD, pitch, site),
        Kind::CrossGable => cross_gabled(pitch, site),
        Kind::Cone | Kind::Dome => round(kind, pitch, site),
        _ => planes(kind, pitch, site),
    };
    match pitch {
        Some(_) => limited(field, f64::from(site.height)),
        None => field,
    }
}

/// What would be higher is a flat top.
fn limited(field: Heights, limit: f64) -> Heights {
    Box::new(move |spot| match field(spot) {
        surface if surface.height > limit => Surface { height: limit, pitch: 0.0 },
        surface => surface,
    })
}

/// Slopes that rise with the depth in a footprint or in a wing of it.
struct Slopes {
    depths: Depths,
    run: f64,
    pitch: f64,
}

impl Slopes {
    fn new(depths: Depths, pitch: Option<f64>, site: &Site) -> Slopes {
        let run = run(&depths, &site.footprint);
        Slopes { depths, run, pitch: pitch.unwrap_or(f64::from(site.height) / run) }
    }

    fn at(&self, spot: Spot, profile: Profile) -> Surface {
        profile.at(f64::from(self.depths.at(spot)) - 0.5, self.run, self.pitch)
    }
}

/// How far from the eaves the ridge is: in the middle of the deepest cell, or behind it where four share a corner.
fn run(depths: &Depths, footprint: &Footprint) -> f64 {
    let deepest = footprint.spots().map(|spot| depths.at(spot)).max().unwrap_or(1).max(1);
    let steps = [Spot::ZERO, Spot::X, Spot::Y, Spot::ONE];
    let is_even = footprint
        .area()
        .grown(1)
        .spots()
        .any(|spot| steps.iter().all(|&step| depths.at(spot + step) == deepest));
    f64::from(deepest) - if is_even { 0.0 } else { 0.5 }
}

fn gabled(profile: Profile, pitch: Option<f64>, site: &Site) -> Heights {
    let ends = gable_ends(&site.footprint, &site.view);
    let slopes = Slopes::new(site.footprint.depths_without(&ends, site.margin()), pitch, site);
    Box::new(move |spot| slopes.at(spot, profile))
}

fn hipped(profile: Profile, pitch: Option<f64>, site: &Site) -> Heights {
    let slopes = Slopes::new(site.footprint.depths(site.margin()), pitch, site);
    Box::new(move |spot| slopes.at(spot, profile))
}

/// A roof for each wing, all with their ridge at the scope's height. Between them goes a hip of the flattest pitch.
fn cross_gabled(pitch: Option<f64>, site: &Site) -> Heights {
    let ends = cross_gable_ends(&site.footprint);
    let wing = |end| Slopes::new(site.footprint.wing_depths(end, &ends, site.margin()), pitch, site);
    let wings: Vec<Slopes> = ends.iter().map(wing).collect();
    let mut hip = Slopes::new(site.footprint.depths(site.margin()), pitch, site);
    hip.pitch = wings.iter().map(|wing| wing.pitch).fold(hip.pitch, f64::min);
    let at = move |spot| {
        let wings = wings.iter().map(|wing| wing.at(spot, Profile::Straight));
        wings.fold(hip.at(spot, Profile::Straight), higher)
    };
    Box::new(at)
}

/// Roofs that rise over the whole rectangle around a footprint, in straight planes.
fn planes(kind: Kind, pitch: Option<f64>, site: &Site) -> Heights {
    let view = site.view;
    let [width, length] = view.lengths().to_array();
    let high = f64::from(site.height);
    // Blocks up over a run, where nothing else is said.
    let over = |run: f64| pitch.unwrap_or(high / run);
    let half = |length: i32| f64::from(length) / 2.0;
    let slope = |at: i32, pitch: f64| Surface::slope(f64::from(at) + 0.5, pitch);
    let from_ends = |at: i32, length: i32| at.min(length - 1 - at);
    let [right, away] = [over(f64::from(width)), over(f64::from(length))];
    // With a pitch, the point of a pyramid is where the slopes of that pitch meet.
    let point = pitch.map_or(high, |pitch| pitch * half(width.min(length)));
    let [aside, ahead, ridge] = [point / half(width), point / half(length), over(half(length))];
    Box::new(move |spot| {
        let [u, v] = view.place(spot).to_array();
        match kind {
            Kind::RightAngleTriangle => slope(width - 1 - u, right),
            Kind::Shed => slope(v, away),
            Kind::Corner => lower(slope(u, right), slope(v, away)),
            Kind::Trough => higher(slope(u, right), slope(v, away)),
            Kind::Pyramid => lower(slope(from_ends(u, width), aside), slope(from_ends(v, length), ahead)),
            _ => slope(from_ends(v, length), ridge),
        }
    })
}

/// Cones and domes over the ellipse in the rectangle around a footprint.
fn round(kind: Kind, pitch: Option<f64>, site: &Site) -> Heights {
    let area = site.footprint.area();
    let half = area.size().as_dvec2() / 2.0;
    let middle = area.min.as_dvec2() + half;
    let radius = half.min_element();
    let high = pitch.map_or(f64::from(site.height), |pitch| pitch * radius);
    let depths = site.footprint.depths(site.margin());
    Box::new(move |spot| {
        let depth = f64::from(depths.at(spot)) - 0.5;
        if depth < 0.0 {
            return Surface::slope(depth, high / radius);
        }
        let out = ((spot.as_dvec2() + 0.5 - middle) / half).length();
        if kind == Kind::Cone || out >= 1.0 {
            return Surface::slope(radius * (1.0 - out), high / radius);
        }
        let rise = (1.0 - out * out).sqrt();
        Surface { height: high * rise, pitch: high / radius * out / rise }
    })
}

fn lower(a: Surface, b: Surface) -> Surface {
    if b.height < a.height { b } else { a }
}

fn higher(a: Surface, b: Surface) -> Surface {
    if b.height > a.height { b } else { a }
}

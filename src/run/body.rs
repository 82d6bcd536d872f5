use crate::space::{Bounds, Footprint, Rect, Scope};
use smallvec::{SmallVec, smallvec};
use std::rc::Rc;

/// A scope and what of its plan is there.
#[derive(Clone, Debug)]
pub struct Body {
    pub scope: Scope,
    /// Lies inside the scope; `None` is all of its plan.
    pub footprint: Option<Rc<Footprint>>,
}

impl Body {
    pub fn whole(scope: Scope) -> Body {
        Body { scope, footprint: None }
    }

    /// What a footprint leaves of a scope, if anything. A scope without a plan is there: `S` may give it one.
    pub fn within(scope: Scope, footprint: Option<&Rc<Footprint>>) -> Option<Body> {
        let ground = Rect::under(&scope.bounds);
        match footprint {
            Some(footprint) if !ground.is_empty() && !covers(footprint, ground) => {
                let inside = match ground.intersect(&footprint.area()) == footprint.area() {
                    true => footprint.clone(),
                    false => Rc::new(footprint.clipped(ground)),
                };
                (!inside.is_empty()).then_some(Body { scope, footprint: Some(inside) })
            }
            _ => Some(Body::whole(scope)),
        }
    }

    /// A scope as small as `footprint`, from `low` to `high` in the world.
    pub fn standing(footprint: Footprint, [low, high]: [i32; 2], scope: &Scope) -> Body {
        let scope = Scope { bounds: footprint.area().between(low, high), ..*scope };
        let footprint = (!footprint.is_rectangle()).then(|| Rc::new(footprint));
        Body { scope, footprint }
    }

    /// The cells of its plan.
    pub fn ground(&self) -> Rc<Footprint> {
        let full = || Rc::new(Footprint::full(Rect::under(&self.scope.bounds)));
        self.footprint.clone().unwrap_or_else(full)
    }

    /// Boxes that tile it.
    pub fn boxes(&self) -> SmallVec<[Bounds; 1]> {
        match &self.footprint {
            None => smallvec![self.scope.bounds],
            Some(footprint) => {
                let [low, high] = self.levels();
                footprint.rectangles().into_iter().map(|area| area.between(low, high)).collect()
            }
        }
    }

    /// How far it reaches up in the world.
    pub fn levels(&self) -> [i32; 2] {
        [self.scope.bounds.min.y, self.scope.bounds.max.y]
    }
}

fn covers(footprint: &Footprint, ground: Rect) -> bool {
    ground.intersect(&footprint.area()) == ground && ground.spots().all(|spot| footprint.contains(spot))
}

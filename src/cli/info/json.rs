use super::tags;
use super::{biomes, block_entities, entities, labels};
use crate::block::Version;
use crate::grid::{Grid, LabelledBoxes, Region};
use crate::io::{Content, Decoded};
use serde_json::{Map, Value, json};

/// What `vox info --json` prints of a file. Keys are added over time, and none is taken away.
pub(super) fn of(name: &str, decoded: &Decoded, notes: &[String]) -> Value {
    let mut fields = match &decoded.content {
        Content::Grid(grid) => of_grid(grid),
        Content::Boxes(boxes) => of_boxes(boxes),
    };
    let about = json!({
        "file": name,
        "format": decoded.about.format.ending(),
        "format_version": decoded.about.version,
        "place": decoded.about.place.map(|place| place.to_array()),
        "odd": notes,
    });
    if let Value::Object(about) = about {
        fields.extend(about);
    }
    Value::Object(fields)
}

fn of_grid(grid: &Grid) -> Map<String, Value> {
    let palette = grid.counts().into_iter().map(|(state, count)| json!([state.to_string(), count]));
    let metadata = &grid.metadata;
    let own = metadata.own.as_ref().map(|own| tags::compound(&own.tags));
    fields(json!({
        "size": grid.size().to_array(),
        "blocks": grid.blocks(),
        "data_version": metadata.data_version,
        "game_version": metadata.data_version.and_then(Version::of_data).map(Version::name),
        "offset": metadata.offset.to_array(),
        "metadata": tags::compound(&metadata.tags),
        "other_tags": own,
        "regions": metadata.regions.iter().map(region).collect::<Vec<_>>(),
        "variants": grid.variants.len(),
        "biomes": biomes(grid),
        "block_entities": grid.block_entities.len(),
        "block_entities_by_id": block_entities(grid),
        "entities": metadata.entities.len(),
        "entities_by_id": entities(grid),
        "palette": palette.collect::<Vec<_>>(),
    }))
}

fn region(region: &Region) -> Value {
    let (low, size) = (region.bounds.min.to_array(), region.bounds.size().to_array());
    json!({ "name": region.name, "place": low, "size": size })
}

fn of_boxes(boxes: &LabelledBoxes) -> Map<String, Value> {
    fields(json!({
        "size": boxes.container.size().to_array(),
        "boxes": boxes.boxes.len(),
        "labels": labels(boxes),
    }))
}

fn fields(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(fields) => fields,
        _ => Map::new(),
    }
}

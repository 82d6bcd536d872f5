//! Grids as meshes: shapes, materials and what is hidden.

use std::collections::BTreeSet;
use vox::block::{self, BlockState, Cuboid, Rgba, boxes};
use vox::grid::Grid;
use vox::io::{ObjMesh, encode_obj_mesh};
use vox::space::{Bounds, Cell};

/// Blocks side by side along x.
fn row(states: &[&str]) -> Grid {
    let mut grid = Grid::new(Cell::new(states.len() as i32, 1, 1));
    for (x, state) in (0..).zip(states) {
        let id = grid.intern(&state.parse().unwrap()).unwrap();
        grid.set(Cell::new(x, 0, 0), id);
    }
    grid
}

fn mesh(states: &[&str]) -> ObjMesh {
    encode_obj_mesh(&row(states), "house.mtl", block::color)
}

type Point = [f64; 3];

/// The faces with their materials.
fn faces(mesh: &ObjMesh) -> Vec<(String, [Point; 4])> {
    let numbers = |words: &str| words.split(' ').map(|word| word.parse::<f64>().unwrap()).collect::<Vec<_>>();
    let (mut points, mut faces, mut material) = (Vec::<Point>::new(), Vec::new(), String::new());
    for line in mesh.obj.lines() {
        match line.split_once(' ').unwrap() {
            ("v", rest) => points.push(numbers(rest).try_into().unwrap()),
            ("usemtl", name) => material = name.to_owned(),
            ("f", rest) => {
                let corners: Vec<Point> = numbers(rest).iter().map(|&n| points[n as usize - 1]).collect();
                faces.push((material.clone(), corners.try_into().unwrap()));
            }
            (keyword, _) => assert_eq!(keyword, "mtllib"),
        }
    }
    faces
}

/// The volume that a closed surface is around, by the theorem of Gauss. Faces counted the wrong way round take away.
fn volume(mesh: &ObjMesh) -> f64 {
    let dot = |a: Point, b: Point| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    faces(mesh).iter().map(|(_, [a, b, c, _])| dot(*a, normal(*a, *b, *c)) / 3.0).sum()
}

/// As long as the face is large.
fn normal(a: Point, b: Point, c: Point) -> Point {
    let [u, v] = [(a, b), (b, c)].map(|(from, to)| [0, 1, 2].map(|i| to[i] - from[i]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// Of all faces that look along x, up or down the axis.
fn area_along_x(mesh: &ObjMesh, material: &str) -> f64 {
    let faces = faces(mesh).into_iter().filter(|(name, _)| name == material);
    faces.map(|(_, [a, b, c, _])| normal(a, b, c)[0].abs()).sum()
}

/// How much of a block its boxes fill together.
fn filled(state: &BlockState) -> f64 {
    let boxes = boxes(state);
    let holds = |part: &Cuboid, cell: Cell| {
        let [low, high] = [part.low, part.high].map(|c| Cell::from_array(c.map(i32::from)));
        Bounds::new(low, high).contains(cell)
    };
    let cells = Bounds::of_size(Cell::splat(16)).cells();
    cells.filter(|&cell| boxes.iter().any(|part| holds(part, cell))).count() as f64 / 4096.0
}

#[test]
fn every_block_alone_is_a_closed_surface_around_its_boxes() {
    let bent = ["inner_left", "inner_right", "outer_left", "outer_right"];
    let bent = bent.map(|shape| format!("minecraft:oak_stairs[facing=west,half=top,shape={shape}]"));
    let all = block::all().iter().map(|known| known.default_state().to_string());
    for state in all.chain(bent) {
        let found = volume(&mesh(&[&state]));
        let expected = filled(&state.parse().unwrap());
        assert!((found - expected).abs() < 1e-9, "{state}: {found}, not {expected}");
    }
}

#[test]
fn whole_blocks_are_drawn_together_and_there_is_one_material_per_block_name() {
    let logs = row(&["oak_log[axis=x]", "oak_log[axis=y]"]);
    let mesh = encode_obj_mesh(&logs, "house.mtl", |_| Rgba::rgb(255, 0, 51));
    assert_eq!(mesh.mtl, "newmtl oak_log\nKd 1.0000 0.0000 0.2000\n");
    let lines: Vec<&str> = mesh.obj.lines().collect();
    let count = |start| lines.iter().filter(|line| line.starts_with(start)).count();
    assert_eq!(lines[0], "mtllib house.mtl");
    assert_eq!([count("v "), count("usemtl oak_log"), count("f ")], [8, 1, 6]);
}

#[test]
fn a_mesh_points_only_to_its_own_vertices_and_materials() {
    let mesh = mesh(&["oak_stairs[facing=east]", "torch", "air", "oak_fence[west=true]", "mod:thing"]);
    let words = |keyword| mesh.obj.lines().filter_map(move |line| line.strip_prefix(keyword));
    let vertices: Vec<&str> = words("v ").collect();
    let used: BTreeSet<usize> =
        words("f ").flat_map(|corners| corners.split(' ').map(|n| n.parse::<usize>().unwrap())).collect();
    assert_eq!(used, (1..=vertices.len()).collect());
    assert_eq!(BTreeSet::from_iter(&vertices).len(), vertices.len(), "each vertex stands once");
    let materials: Vec<&str> = words("usemtl ").collect();
    assert_eq!(materials, ["detail_6a4b2cff", "mod:thing", "oak_fence", "oak_stairs", "torch"]);
    assert!(materials.iter().all(|name| mesh.mtl.contains(&format!("newmtl {name}\n"))));
}

#[test]
fn faces_are_hidden_where_a_neighbour_covers_them() {
    // Blocks in a row, the material that is looked at, and how much of it is to be seen along x.
    let cases: [(&[&str], &str, f64); 12] = [
        (&["stone"], "stone", 2.0),
        (&["stone", "stone"], "stone", 2.0),
        (&["stone", "dirt"], "stone", 1.0),
        (&["stone", "oak_slab"], "stone", 2.0),
        (&["stone", "oak_slab"], "oak_slab", 0.5),
        (&["oak_slab", "birch_slab"], "oak_slab", 0.5),
        (&["oak_slab", "birch_slab[type=top]"], "oak_slab", 1.0),
        // The back of the stairs is a whole side, the front has two steps.
        (&["oak_stairs[facing=east]", "stone"], "stone", 1.0),
        (&["stone", "oak_stairs[facing=east]"], "stone", 2.0),
        (&["oak_stairs[facing=east]", "oak_stairs[facing=west]"], "oak_stairs", 2.0),
        (&["glass", "stone"], "stone", 2.0),
        (&["glass", "glass", "red_stained_glass"], "glass", 2.0),
    ];
    for (states, material, expected) in cases {
        let found = area_along_x(&mesh(states), material);
        assert!((found - expected).abs() < 1e-9, "{states:?}: {found} of {material}, not {expected}");
    }
    assert_eq!(
        area_along_x(&mesh(&["glass", "stone"]), "glass"),
        1.0,
        "behind stone there is nothing to see"
    );
}

#[test]
fn what_can_be_seen_through_says_so() {
    let mesh = mesh(&["glass"]);
    assert_eq!(mesh.mtl, "newmtl glass\nKd 0.8118 0.9020 0.9333\nd 0.3451\nTr 0.6549\n");
}

#[test]
fn what_is_not_to_be_seen_is_not_drawn() {
    assert_eq!(mesh(&["air", "structure_void", "light", "barrier"]).obj, "mtllib house.mtl\n");
}

//! Case 12: a column of 200 layers. Its compression is that of the column law within 20 % while
//! the law says less than 0.2, and no particle is lost under it.

use brooklet_fluid::scene::Acceleration;
use brooklet_tests::column::Setup;

#[test]
fn two_hundred_layers_follow_the_law() {
    let setup = Setup {
        layers: 200,
        width: 4,
        iterations: 4,
        substeps: 1,
        dt_s: 1.0 / 240.0,
        acceleration: Acceleration::None,
    }
    .at(0.18);
    let settled = setup.settle();
    println!(
        "case 12: 200 layers: law {:.4}, measured {:.4}, swinging by {:.4}; the middle sank by {:.3} of the height",
        settled.law, settled.bottom, settled.unrest, settled.sunk
    );
    // 1.5 times the error measured, 7.6 %.
    assert!((settled.bottom / settled.law - 1.0).abs() < 0.115, "{settled:?}");
    assert!(settled.unrest < 0.001, "{settled:?}");
    // A quarter and half way up, too: compression falls evenly.
    for layer in [50, 100, 150] {
        let law = settled.law * (1.0 - layer as f64 / 200.0);
        let near = settled.layers[layer - 2..layer + 2].iter().sum::<f64>() / 4.0;
        println!("layer {layer}: {near:.4}, the law says {law:.4}");
        assert!((near / law - 1.0).abs() < 0.115, "layer {layer}: {near}, the law says {law}");
    }
}

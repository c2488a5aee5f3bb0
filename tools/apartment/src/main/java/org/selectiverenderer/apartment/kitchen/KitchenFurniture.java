package org.selectiverenderer.apartment.kitchen;

import static org.selectiverenderer.apartment.kitchen.CupboardFronts.bow;
import static org.selectiverenderer.apartment.kitchen.CupboardFronts.door;
import static org.selectiverenderer.apartment.kitchen.CupboardFronts.drawer;
import static org.selectiverenderer.apartment.kitchen.CupboardFronts.knob;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.TextureMapping;

/**
 * Five units of 0.6 m along a wall, from the left: cupboard, sink, drawers, oven below the hob,
 * cupboard; above them a tiled wall and hanging cupboards, also over the hob. The worktop is 0.9 m
 * high; its front edge is at z = 0.3 before the model is centred, the wall at z = -0.3.
 */
final class KitchenFurniture {
  private static final double[] UNIT = {-1.5, -0.9, -0.3, 0.3, 0.9, 1.5};
  private static final double SINK_X = -0.6;
  private static final double HOB_X = 0.6;
  private static final double TOP = 0.9;
  private static final double UNDER_TOP = 0.86;
  private static final double PLINTH = 0.1;
  private static final double HANGING = 1.42;
  private static final double HEIGHT = 2.14;

  /** The z of the fronts' backs, of the lower and the upper cupboards, metres. */
  private static final double LOWER_Z = 0.26;

  private static final double UPPER_Z = 0.03;

  private static final ModelMaterial TILES =
      ModelMaterial.satin(ModelColour.grey(1))
          .clad(
              TextureMapping.metric(
                  TextureRegistry.WALL_TILES,
                  TextureRegistry.WALL_TILES_SIZE,
                  TextureRegistry.WALL_TILES_SIZE));

  private KitchenFurniture() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "kitchenFurniture",
        Part.of("carcass", ModelMaterial.satin(ModelColour.hex(0xD9D5CA)), carcass()),
        Part.of("plinth", Materials.SOFT_BLACK, BoxBuilder.plain(3, PLINTH, 0.5).move(0, 0, -0.05)),
        Part.of(
            "fronts", ModelMaterial.satin(ModelColour.hex(0x9FB0A2)), lowerFronts(), upperFronts()),
        Part.of("worktop", Materials.LIGHT_OAK, worktop()),
        Part.of("tiles", TILES, tiles()),
        Part.of("sink", Materials.POLISHED_STEEL, SinkAndHob.basin().move(SINK_X, TOP, 0)),
        Part.of("steel", Materials.POLISHED_STEEL, handles(), fittings()),
        Part.of("black", Materials.SOFT_BLACK, SinkAndHob.hobGlass().move(HOB_X, TOP, 0), oven()),
        Part.of("rings", Materials.DARK_STEEL, SinkAndHob.hobRings().move(HOB_X, TOP, 0)));
  }

  private static TriangleMesh carcass() {
    TriangleMesh lower =
        BoxBuilder.plain(3, UNDER_TOP - PLINTH - 0.17, 0.56).move(0, PLINTH, -0.02);
    TriangleMesh rail = BoxBuilder.plain(3, 0.17, 0.04).move(0, UNDER_TOP - 0.17, LOWER_Z - 0.02);
    TriangleMesh upper = BoxBuilder.plain(3, HEIGHT - HANGING, 0.33).move(0, HANGING, -0.135);
    TriangleMesh sides =
        BoxBuilder.plain(0.02, UNDER_TOP - PLINTH, 0.56).move(-1.49, PLINTH, -0.02);
    return TriangleMesh.of(lower, rail, upper, sides, sides.mirrorX());
  }

  private static TriangleMesh lowerFronts() {
    double step = (UNDER_TOP - PLINTH) / 4;
    TriangleMesh drawers = TriangleMesh.EMPTY;
    for (int i = 0; i < 4; i++) {
      double y = PLINTH + i * step;
      drawers = drawers.append(drawer(UNIT[2], y, UNIT[3], y + step));
    }
    return TriangleMesh.of(
            door(UNIT[0], PLINTH, UNIT[1], UNDER_TOP),
            door(UNIT[1], PLINTH, SINK_X, UNDER_TOP),
            door(SINK_X, PLINTH, UNIT[2], UNDER_TOP),
            drawers,
            door(UNIT[4], PLINTH, UNIT[5], UNDER_TOP))
        .move(0, 0, LOWER_Z);
  }

  private static TriangleMesh upperFronts() {
    List<TriangleMesh> doors = new ArrayList<>();
    for (int unit = 0; unit < UNIT.length - 1; unit++) {
      double middle = (UNIT[unit] + UNIT[unit + 1]) / 2;
      doors.add(door(UNIT[unit], HANGING, middle, HEIGHT));
      doors.add(door(middle, HANGING, UNIT[unit + 1], HEIGHT));
    }
    return TriangleMesh.of(doors).move(0, 0, UPPER_Z);
  }

  private static TriangleMesh worktop() {
    SimplePolygon edge = SimplePolygon.rectangle(3.02, 0.6);
    SimplePolygon opening = SinkAndHob.OPENING.move(SINK_X, 0);
    return ExtrudedSolid.plate(TOP - UNDER_TOP, 0.006, 2, edge, opening).move(0, UNDER_TOP, 0);
  }

  /**
   * Returns the surface that carries the texture of tiles, between worktop and hanging cupboards.
   */
  private static TriangleMesh tiles() {
    return BoxBuilder.plain(3, HANGING - TOP, 0.008).move(0, TOP, -0.296);
  }

  private static TriangleMesh handles() {
    List<TriangleMesh> below = new ArrayList<>();
    below.add(bow(0.16, -1.2, UNDER_TOP - 0.045));
    below.add(knob(SINK_X - 0.035, UNDER_TOP - 0.12));
    below.add(knob(SINK_X + 0.035, UNDER_TOP - 0.12));
    for (int i = 0; i < 4; i++) {
      below.add(bow(0.16, 0, PLINTH + 0.115 + 0.19 * i));
    }
    below.add(bow(0.46, HOB_X, 0.68));
    below.add(bow(0.16, 1.2, UNDER_TOP - 0.045));
    List<TriangleMesh> above = new ArrayList<>();
    for (double middle : new double[] {-1.2, -0.6, 0, 0.6, 1.2}) {
      above.add(knob(middle - 0.035, HANGING + 0.12));
      above.add(knob(middle + 0.035, HANGING + 0.12));
    }
    return TriangleMesh.of(
        TriangleMesh.of(below).move(0, 0, LOWER_Z), TriangleMesh.of(above).move(0, 0, UPPER_Z));
  }

  /** Returns the tap and the oven's panel with its knobs. */
  private static TriangleMesh fittings() {
    List<TriangleMesh> all = new ArrayList<>();
    all.add(SinkAndHob.tap().move(SINK_X, TOP, 0));
    all.add(drawer(UNIT[3], 0.74, UNIT[4], UNDER_TOP).move(0, 0, LOWER_Z));
    all.add(drawer(UNIT[3], PLINTH, UNIT[4], 0.2).move(0, 0, LOWER_Z));
    TriangleMesh dial = RoundSolidBuilder.roundedCylinder(0.02, 0.022, 0.005, 3, 24).turnX(90);
    for (int i = 0; i < 5; i++) {
      all.add(dial.move(HOB_X - 0.2 + 0.1 * i, 0.8, LOWER_Z + CupboardFronts.THICKNESS));
    }
    return TriangleMesh.of(all);
  }

  /** Returns the oven's door with a slightly raised window. */
  private static TriangleMesh oven() {
    TriangleMesh window =
        ExtrudedSolid.bevelled(0.008, 0.004, 2, SimplePolygon.roundedRectangle(0.42, 0.3, 0.03, 4));
    return drawer(UNIT[3], 0.2, UNIT[4], 0.74)
        .append(window.move(HOB_X, 0.44, CupboardFronts.THICKNESS - 0.002))
        .move(0, 0, LOWER_Z);
  }
}

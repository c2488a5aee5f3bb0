package org.selectiverenderer.apartment.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apartment.plan.RoomPosition.Against;
import org.selectiverenderer.apartment.plan.RoomPosition.Ceiling;
import org.selectiverenderer.apartment.plan.RoomPosition.Floor;
import org.selectiverenderer.apartment.plan.RoomPosition.Hung;
import org.selectiverenderer.apartment.plan.RoomPosition.On;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

class PlacementResolverTest {
  private static final TriangleMesh FLOOR =
      TriangleMesh.of(
          ParametricSurface.field(40, 10, 1, 1, (x, z) -> 0),
          BoxBuilder.plain(2, 0.01, 2).move(5, 0, 0));

  private final Map<String, ParametricModel> models =
      Map.of(
          "table",
              model(BoxBuilder.plain(2, 0.1, 1).move(0, 0.7, 0), BoxBuilder.plain(0.1, 0.7, 0.1)),
          "box", model(BoxBuilder.plain(0.2, 0.2, 0.4)),
          "shelf",
              model(BoxBuilder.plain(1, 0.02, 0.3).move(0, 0.5, 0), BoxBuilder.plain(1, 0.02, 0.3)),
          "ball", model(RoundSolidBuilder.sphere(0.1, 16, 16)));

  @Test
  void whatStandsOnTheFloorTouchesIt() {
    assertThat(place("ball", new Floor(3, 1, 0)).y()).isCloseTo(0.1, within(1e-4));
    assertThat(place("ball", new Floor(5, 0, 0)).y()).isCloseTo(0.11, within(1e-4));
  }

  @Test
  void aBackIsAgainstEachWall() {
    Room room = Room.OFFICE;
    assertThat(place("box", new Against(WallSide.NORTH, 4, 0.05)))
        .satisfies(p -> assertThat(p.z()).isCloseTo(Room.NORTH + 0.25, within(1e-4)))
        .satisfies(p -> assertThat(p.x()).isEqualTo(4));
    assertThat(place("box", new Against(WallSide.EAST, 1, 0)).x())
        .isCloseTo(room.east() - 0.2, within(1e-4));
    assertThat(place("box", new Against(WallSide.SOUTH, 4, 0)).yaw()).isEqualTo(180);
    assertThat(place("box", new Hung(WallSide.WEST, 1, 1.5)))
        .satisfies(p -> assertThat(p.x()).isCloseTo(room.west() + 0.2, within(1e-4)))
        .satisfies(p -> assertThat(p.y()).isCloseTo(1.5, within(1e-4)));
  }

  @Test
  void whatHangsFromTheCeilingHasItsUpperEndThere() {
    assertThat(place("ball", new Ceiling(3, 1)).y()).isCloseTo(Room.CEILING - 0.1, within(1e-4));
  }

  @Test
  void aThingIsLetDownOntoWhatIsBelow() {
    PlacedObject box = place("box", new On("table", 0.5, 0, 90, 2), new Floor(3, 0, 90));

    assertThat(box.y()).isCloseTo(0.8, within(1e-4));
    // The table is turned, so its x points north.
    assertThat(box.x()).isCloseTo(3, within(1e-4));
    assertThat(box.z()).isCloseTo(-0.5, within(1e-4));
    assertThat(box.yaw()).isEqualTo(180);
  }

  @Test
  void fromWithinAShelfTheBoardsAboveDoNotCount() {
    PlannedObject shelf = new PlannedObject(Room.OFFICE, "shelf", 1, new Floor(3, 0, 0));
    PlannedObject box = new PlannedObject(Room.OFFICE, "box", 1, new On("shelf", 0, 0, 90, 0.4));
    List<PlacedObject> placed =
        PlacementResolver.of(List.of(box, shelf), models::get, room -> FLOOR);

    assertThat(placed.get(0).y()).isCloseTo(0.02, within(1e-4));
    assertThat(placed.get(0).object()).isEqualTo("box");
  }

  @Test
  void whatHasNothingBelowIsSaid() {
    assertThatThrownBy(() -> place("box", new On("table", 5, 0, 0, 2), new Floor(4, 0, 0)))
        .hasMessage("box does not lie above table");
    assertThatThrownBy(() -> place("box", new On("nothing", 0, 0, 0, 2)))
        .hasMessageContaining("nothing");
    assertThatThrownBy(() -> place("box", new Floor(400, 0, 0)))
        .hasMessage("box does not lie above the floor");
  }

  @Test
  void boxesThatAreTurnedApartDoNotOverlap() {
    Footprint a = new Footprint(place("box", new Floor(4, 0, 45)));
    Footprint b = new Footprint(place("box", new Floor(4.22, -0.22, 45)));
    Footprint c = new Footprint(place("box", new Floor(4.1, -0.1, 45)));

    assertThat(a.overlap(b)).isNegative();
    assertThat(a.overlap(c)).isPositive();
  }

  private PlacedObject place(String object, RoomPosition place) {
    PlannedObject row = new PlannedObject(Room.OFFICE, object, 1, place);
    return PlacementResolver.of(List.of(row), models::get, room -> FLOOR).get(0);
  }

  private PlacedObject place(String object, RoomPosition place, RoomPosition table) {
    PlannedObject below = new PlannedObject(Room.OFFICE, "table", 1, table);
    PlannedObject row = new PlannedObject(Room.OFFICE, object, 1, place);
    return PlacementResolver.of(List.of(below, row), models::get, room -> FLOOR).get(1);
  }

  private static ParametricModel model(TriangleMesh... meshes) {
    return ParametricModel.of(
        "any", Part.of("part", ModelMaterial.matt(ModelColour.grey(0.5)), meshes));
  }
}

package org.selectiverenderer.apartment.building;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExactCountRefiner;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

class RoomModelsTest {

  @ParameterizedTest
  @EnumSource(Room.class)
  void aRoomIsClosedByItsWallsAndReachesAsFarAsThePlan(Room room) {
    ParametricModel frame = RoomModels.of(room);
    BoundingBox walls = part(frame, "walls").bounds();

    assertThat(part(frame, "walls").isClosed()).isTrue();
    assertThat(walls.minX()).isBetween(room.west() - 0.21, room.west() - 0.05);
    assertThat(walls.maxX()).isBetween(room.east() + 0.05, room.east() + 0.21);
    assertThat(walls.minY()).isZero();
    assertThat(walls.maxY()).isCloseTo(Room.HEIGHT, within(1e-6));
  }

  @ParameterizedTest
  @EnumSource(Room.class)
  void itLeavesPolygonsForTheInconsistentObjects(Room room) {
    assertThat(RoomModels.of(room).polygons()).isLessThan(room.fixedPolygons() * 6 / 10);
  }

  /** Evenness is what the floor's and ceiling's borders are for. */
  @ParameterizedTest
  @EnumSource(Room.class)
  void itCanBeBroughtToAnyCount(Room room) {
    ParametricModel frame = RoomModels.of(room);

    assertThat(ExactCountRefiner.refine(frame, frame.polygons() + 1001).polygons())
        .isEqualTo(frame.polygons() + 1001);
  }

  @Test
  void theCeilingsAreSeenFromBelowOnly() {
    for (Room room : Room.values()) {
      Part ceiling = find(RoomModels.of(room), "ceiling");
      assertThat(ceiling.bothSides()).isFalse();
      TriangleMesh mesh = ceiling.mesh();
      float[] p = mesh.positions();
      int[] t = mesh.triangles();
      double up =
          (p[3 * t[1] + 2] - p[3 * t[0] + 2]) * (p[3 * t[2]] - p[3 * t[0]])
              - (p[3 * t[1]] - p[3 * t[0]]) * (p[3 * t[2] + 2] - p[3 * t[0] + 2]);
      assertThat(up).isNegative();
    }
  }

  @Test
  void theLampsOfTheOfficeLieFlatUnderItsCeiling() {
    for (ParametricModel frame :
        new ParametricModel[] {RoomModels.of(Room.OFFICE), RoomModels.bare(Room.OFFICE)}) {
      BoundingBox rims = part(frame, "lampRims").bounds();
      BoundingBox lights = part(frame, "lampLights").bounds();

      assertThat(rims.maxY()).isCloseTo(Room.HEIGHT, within(1e-6));
      assertThat(rims.minY()).isBetween(Room.HEIGHT - 0.07, lights.minY());
      assertThat(rims.minZ()).isLessThan(lights.minZ());
      assertThat(rims.maxZ()).isGreaterThan(lights.maxZ());
    }
  }

  /** What is divided for radiosity has no vertices in walls, where there is no light. */
  @ParameterizedTest
  @EnumSource(Room.class)
  void aBareCeilingEndsAtTheWalls(Room room) {
    BoundingBox ceiling = part(RoomModels.bare(room), "ceiling").bounds();

    assertThat(ceiling.minX()).isBetween(room.west() - 0.005, room.west());
    assertThat(ceiling.maxX()).isBetween(room.east(), room.east() + 0.005);
    assertThat(ceiling.minZ()).isBetween(Room.NORTH - 0.005, Room.NORTH);
    assertThat(ceiling.maxZ()).isBetween(Room.SOUTH, Room.SOUTH + 0.005);
  }

  /** Boards and tiles are pictures: they take no polygons. */
  @ParameterizedTest
  @EnumSource(Room.class)
  void aFloorIsTwoTriangles(Room room) {
    Part floor = find(RoomModels.of(room), "floor");

    assertThat(floor.mesh().triangleCount()).isEqualTo(2);
    assertThat(floor.look().cladding()).isNotNull();
  }

  /** Plaster darkens the paint by as much as the paint is lighter than the wall. */
  @Test
  void aPlasteredWallThrowsBackTheLightOfItsColour() {
    ModelMaterial wall = find(RoomModels.of(Room.LOUNGE), "walls").look();

    assertThat(Srgb.light(wall.diffuse().green()) * TextureRegistry.PLASTER_LIGHT)
        .isCloseTo(Srgb.light(0.78), within(0.002));
  }

  @Test
  void theShadowHasThePolygonsThatItSays() {
    String index = BlobShadow.text().split("coordIndex='")[1].split("'")[0];

    assertThat(index.split(" -1", -1)).hasSize(BlobShadow.polygons() + 1);
  }

  private static TriangleMesh part(ParametricModel model, String name) {
    return find(model, name).mesh();
  }

  private static Part find(ParametricModel model, String name) {
    return model.parts().stream().filter(p -> p.name().equals(name)).findFirst().orElseThrow();
  }
}

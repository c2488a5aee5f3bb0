package org.selectiverenderer.app.headset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.hmd.TestWorlds;

/** A press on the stick takes the user of a headset to the middle of a room. */
class RoomTeleportTest {
  /** Two rooms of 4 by 4 m with a floor, a back wall and a chair; the second is one step up. */
  private static final String ROOMS = room("Hall", 0, 0) + room("Study", 10, 0.5);

  private static String room(String name, double x, double y) {
    return ("<Transform DEF='%s' translation='%s %s 0'>"
            + "<Transform DEF='%sFloor'><Shape><Box size='4 0.02 4'/></Shape></Transform>"
            + "<Transform DEF='%sWall' translation='0 1.5 -2'><Shape><Box size='4 3 0.02'/></Shape>"
            + "</Transform><Transform DEF='%sChair' translation='-1 0.5 1'><Shape>"
            + "<Box size='0.5 1 0.5'/></Shape></Transform></Transform>")
        .formatted(name, x, y, name, name, name);
  }

  /** Where the head of one who stands there is after a press; yaw and pitch in degrees. */
  private static Vector3dc gone(World world, Vector3d from, double yaw, double pitch) {
    world.viewer().moveTo(from);
    world
        .viewer()
        .turnTo(new Quaterniond().rotationYXZ(Math.toRadians(yaw), Math.toRadians(pitch), 0));
    return world.viewer().position();
  }

  private static void assertAt(Vector3dc at, double x, double y, double z) {
    assertThat(at.distance(new Vector3d(x, y, z))).as("at %s", at).isCloseTo(0, within(0.02));
  }

  @Test
  void goesToTheMiddleOfTheRoomThatIsLookedAtAsHighAboveItsFloor() throws IOException {
    World world = TestWorlds.world(ROOMS);
    // From the hall's corner over to the study's floor, which is half a metre higher.
    gone(world, new Vector3d(1.5, 1.7, 0.5), -90, -8);
    assertThat(RoomTeleport.go(world)).contains("Study");
    assertAt(world.viewer().position(), 10, 2.2, 0);
  }

  @Test
  void goesToTheMiddleOfItsOwnRoomWhereTheSkyIsLookedAt() throws IOException {
    World world = TestWorlds.world(ROOMS);
    gone(world, new Vector3d(1.5, 1.7, 1.5), 0, 90);
    assertThat(RoomTeleport.go(world)).contains("Hall");
    assertAt(world.viewer().position(), 0, 1.7, 0);
  }

  @Test
  void theHeadKeepsTheWayItLooks() throws IOException {
    World world = TestWorlds.world(ROOMS);
    gone(world, new Vector3d(1.5, 1.7, 0.5), 30, -20);
    Quaterniond before = new Quaterniond(world.viewer().orientation());
    assertThat(RoomTeleport.go(world)).contains("Hall");
    assertThat(world.viewer().orientation()).isEqualTo(before);
  }

  @Test
  void outsideOfAllRoomsNobodyIsMoved() throws IOException {
    World world = TestWorlds.world(ROOMS);
    Vector3dc from = new Vector3d(gone(world, new Vector3d(50, 1.7, 50), 180, 0));
    assertThat(RoomTeleport.go(world)).isEmpty();
    assertThat(world.viewer().position()).isEqualTo(from);
  }

  @Test
  void anEmptySceneHasNoRoom() throws IOException {
    World world = TestWorlds.world("<Viewpoint/>");
    assertThat(RoomTeleport.go(world)).isEmpty();
  }
}

package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;

/** A room of 6 by 6 metres; in it a desk's area of 2 by 4, turned by 90 degrees about (1, 0). */
class MovementBoundsTest {
  private static final String SCENE =
      """
      <X3D version='4.0' profile='Immersive'><Scene>
      <NavigationInfo avatarSize='0.25 1.6 0.3'/>
      <Viewpoint DEF='Here' position='0 1.6 0'/>
      <Group DEF='Office'>
        <Shape DEF='Walls'><Box size='6 4 6'/></Shape>
        <Transform DEF='Desk' translation='1 0 0'><Shape><Box/></Shape></Transform>
      </Group>
      <Transform translation='1 1 0' rotation='0 1 0 1.5707963267948966'>
        <ProximitySensor DEF='DeskProx' size='2 4 4'/>
      </Transform>
      <Transform translation='50 0 0'><ProximitySensor DEF='Elsewhere' size='2 4 4'/></Transform>
      </Scene></X3D>
      """;

  /** Eight metres per second to the right and away. */
  private static final ViewerMotion AWAY =
      (viewer, time, dt) -> viewer.moveTo(new Vector3d(viewer.position()).add(8 * dt, 0, 8 * dt));

  @TempDir private Path folder;
  private Walkthrough walk;
  private Viewer viewer;

  @BeforeEach
  void scene() throws IOException {
    Path file = Files.writeString(folder.resolve("office.x3d"), SCENE);
    walk =
        Walkthrough.open(
            file, SelectiveController.Settings.SELECTIVE, p -> {}, event -> {}, text -> {});
    walk.step(0, (moved, time, dt) -> {});
    viewer = walk.world().viewer();
  }

  @AfterEach
  void close() {
    walk.close();
  }

  private void walkFor(int seconds, ViewerMotion motion) {
    for (int i = 1; i <= 10 * seconds; i++) {
      motion.move(viewer, i * 0.1, 0.1);
    }
  }

  @Test
  void whoOnlyTurnsStaysWhereHeIs() {
    Vector3d home = new Vector3d(viewer.position());
    walkFor(1, MovementBounds.standing(viewer, AWAY));
    assertThat(viewer.position()).isEqualTo(home);
  }

  @Test
  void aRoomIsLeftByNoMoreThanTheBodysDistanceFromItsSides() {
    MovementBounds room = MovementBounds.open(walk);
    assertThat(room.addRoom()).isTrue();
    walkFor(2, room.around(AWAY));
    assertThat(viewer.position().x()).isCloseTo(2.75, within(1e-9));
    assertThat(viewer.position().z()).isCloseTo(2.75, within(1e-9));
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-6));
  }

  @Test
  void aSensorsBoxIsKeptToAsItStandsAndAlongItOneSlides() {
    MovementBounds desk = MovementBounds.open(walk);
    assertThat(desk.add("DeskProx")).isTrue();
    walkFor(2, desk.around(AWAY));
    // Turned by 90 degrees it is 4 wide and 2 deep.
    assertThat(viewer.position().x()).isCloseTo(3, within(1e-3)).isLessThan(3);
    assertThat(viewer.position().z()).isCloseTo(1, within(1e-3)).isLessThan(1);
    walk.step(3, (moved, time, dt) -> {});
    assertThat(walk.world().scene().find("DeskProx").orElseThrow())
        .satisfies(
            sensor -> assertThat(sensor.value(sensor.type().indexOf("isActive"))).isEqualTo(true));
  }

  @Test
  void bothHoldTogether() {
    MovementBounds both = MovementBounds.open(walk);
    assertThat(both.add("DeskProx")).isTrue();
    assertThat(both.add("Office")).isTrue();
    walkFor(2, both.around(AWAY));
    assertThat(viewer.position().x()).isCloseTo(2.75, within(1e-9));
    assertThat(viewer.position().z()).isCloseTo(1, within(1e-3));
  }

  @Test
  void whoIsNotInItIsNotPutThere() {
    MovementBounds none = MovementBounds.open(walk);
    assertThat(none.add("Elsewhere")).isFalse();
    assertThat(none.add("Nowhere")).isFalse();
    viewer.moveTo(new Vector3d(20, 1.6, 0));
    assertThat(none.addRoom()).isFalse();
    walkFor(1, none.around(AWAY));
    assertThat(viewer.position().x()).isCloseTo(28, within(1e-9));
  }
}

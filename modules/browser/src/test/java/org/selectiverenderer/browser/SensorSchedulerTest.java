package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;

class SensorSchedulerTest {
  private static final int SENSORS = 60;
  private static final int FRAMES = 1500;

  /** A scene whose sensors are asked by a round, or one after the other as the standard says it. */
  private static final class Walk implements AutoCloseable {
    final WorldFixture fixture;
    final List<FrameDrivenNode> nodes;
    final SensorScheduler round;
    int looked;

    Walk(String scene) {
      fixture = new WorldFixture(scene);
      World world = fixture.world;
      nodes = LayerNodeIndex.of(world.scene(), true, world.instances()).frameNodes();
      round = new SensorScheduler(nodes);
      world.instances().onMoved(round::moved);
    }

    void frame(double time, Vector3d eye, boolean all) {
      World world = fixture.world;
      world.cascade().at(time);
      world.viewer().moveTo(eye);
      world.cascade().run();
      world.instances().update();
      WorldFrameContext frame =
          new WorldFrameContext(time, world.viewer(), world.instances(), Optional::empty);
      if (all) {
        nodes.forEach(node -> node.frame(frame, world.cascade()));
      } else {
        looked = round.frame(frame, world.cascade());
      }
      world.cascade().run();
    }

    @Override
    public void close() {
      fixture.close();
    }
  }

  private static String scene() {
    StringBuilder text =
        new StringBuilder("<TimeSensor DEF='Clock' cycleInterval='3' loop='true'/>");
    text.append("<PositionInterpolator DEF='Way' key='0 1' keyValue='-6 0 0 6 0 0'/>");
    for (int i = 0; i < SENSORS; i++) {
      text.append(
          "<Transform DEF='T%d' translation='%d 0 %d'><Transform DEF='U%d'>"
              .formatted(i, 3 * (i % 8) - 12, 3 * (i / 8) - 12, i));
      text.append("<ProximitySensor DEF='P%d' size='4 4 4'/></Transform></Transform>".formatted(i));
    }
    // One that stands in two places, and groups that come and go.
    text.append("<Group DEF='Places'><Transform DEF='V' translation='5 0 5'>");
    text.append("<ProximitySensor USE='P3'/></Transform></Group><Group DEF='More'/>");
    text.append("<TimeSensor DEF='Late' cycleInterval='2' loop='true'/>");
    text.append(route("Clock", "fraction_changed", "Way", "set_fraction"));
    text.append(route("Way", "value_changed", "P5", "center"));
    text.append(route("Way", "value_changed", "T9", "translation"));
    for (int i = 10; i < 30; i++) { // Forwards and backwards in the order of the scene.
      text.append(route("P" + i, "isActive", "P" + (i * 7 % SENSORS), "enabled"));
      text.append(route("P" + i, "position_changed", "P" + (i * 11 % SENSORS), "center"));
    }
    return text.toString();
  }

  private static String route(String from, String output, String to, String input) {
    return "<ROUTE fromNode='%s' fromField='%s' toNode='%s' toField='%s'/>"
        .formatted(from, output, to, input);
  }

  @Test
  void sendsTheEventsOfARoundThroughAllSensorsWhateverMovesChangesComesAndGoes() {
    String scene = scene();
    try (Walk all = new Walk(scene);
        Walk near = new Walk(scene)) {
      for (Walk walk : List.of(all, near)) {
        for (int i = 0; i < SENSORS; i++) {
          for (String field : List.of("isActive", "enterTime", "exitTime", "position_changed")) {
            walk.fixture.watch("P" + i, field);
          }
        }
        walk.fixture.watch("Late", "fraction_changed");
      }
      Random random = new Random(14);
      Vector3d eye = new Vector3d();
      int changes = 0;
      for (int frame = 0; frame < FRAMES; frame++) {
        if (random.nextInt(3) == 0) {
          Change change = Change.any(random);
          change.apply(all.fixture);
          change.apply(near.fixture);
        }
        eye.add(random.nextGaussian(), 0.1 * random.nextGaussian(), random.nextGaussian());
        eye.mul(0.99);
        double time = frame / 10.0;
        all.frame(time, eye, true);
        near.frame(time, eye, false);

        assertThat(near.fixture.log).as("frame %s", frame).isEqualTo(all.fixture.log);
        changes += all.fixture.log.size();
        all.fixture.log.clear();
        near.fixture.log.clear();
      }
      assertThat(changes).isGreaterThan(2 * FRAMES);
    }
  }

  /** Something that happens between two frames. */
  private record Change(String node, String field, Object value) {
    static Change any(Random random) {
      int i = random.nextInt(SENSORS);
      return switch (random.nextInt(8)) {
        case 0 -> new Change("P" + i, "enabled", random.nextBoolean());
        case 1 -> new Change("P" + i, "size", three(random, 0, 6));
        case 2 -> new Change("P" + i, "center", three(random, -2, 2));
        case 3 -> new Change("T" + i, "translation", three(random, -12, 12));
        case 4 -> new Change("U" + i, "scale", three(random, random.nextBoolean() ? 0.2f : 0, 2));
        case 5 -> new Change("T" + i, "rotation", new float[] {0, 1, 1, random.nextFloat() * 6});
        case 6 -> new Change("U" + i, "scale", new float[] {1, random.nextFloat() * 1e-6f, 1});
        default -> new Change(random.nextBoolean() ? "More" : "Places", "children", i);
      };
    }

    private static float[] three(Random random, float low, float high) {
      float[] values = new float[3];
      for (int axis = 0; axis < 3; axis++) {
        values[axis] = low + (high - low) * random.nextFloat();
      }
      return values;
    }

    void apply(WorldFixture fixture) {
      fixture.send(
          node,
          field,
          value instanceof Integer i
              ? new ArrayList<>(List.of(fixture.node("P" + i), fixture.node("V")))
              : value);
    }
  }

  @Test
  void onlySensorsNearTheViewerLookAtAFrame() {
    StringBuilder scene = new StringBuilder();
    for (int i = 0; i < 2000; i++) {
      scene.append(
          "<Transform DEF='T%d' translation='%d 0 0'><ProximitySensor size='2 2 2'/></Transform>"
              .formatted(i, 5 * i));
    }
    try (Walk walk = new Walk(scene.toString())) {
      walk.frame(0, new Vector3d(5000, 0, 0), false);
      assertThat(walk.looked).as("inside one").isBetween(1, 8);

      walk.frame(1, new Vector3d(5002.5, 0, 0), false);
      assertThat(walk.looked).as("leaving it").isBetween(1, 8);

      walk.frame(2, new Vector3d(0, 100, 0), false);
      assertThat(walk.looked).as("near none").isZero();

      walk.fixture.send("T7", "translation", new float[] {0, 100, 0});
      walk.frame(3, new Vector3d(0, 100, 0), false);
      assertThat(walk.looked).as("one that has come near").isBetween(1, 8);
    }
  }

  @Test
  void aBoxThatAClockBringsToTheViewerIsEnteredInTheSameFrame() {
    String scene =
        """
        <TimeSensor DEF='Clock' cycleInterval='2' loop='true'/>
        <PositionInterpolator DEF='Way' key='0 0.5 1' keyValue='90 0 0 0 0 0 90 0 0'/>
        <ProximitySensor DEF='P' size='2 2 2' center='90 0 0'/>
        """
            + route("Clock", "fraction_changed", "Way", "set_fraction")
            + route("Way", "value_changed", "P", "center");
    try (WorldFixture fixture = new WorldFixture(scene)) {
      fixture.watch("P", "isActive");
      for (double time : new double[] {0.1, 1, 1.1}) {
        fixture.step(time, 0, 0, 0);
      }

      assertThat(fixture.log).containsExactly("1.00 P.isActive=true", "1.10 P.isActive=false");
    }
  }

  @Test
  void aPlaceAddedWhileTheWorldRunsIsSensed() {
    try (WorldFixture fixture =
        new WorldFixture(
            "<ProximitySensor DEF='P' size='2 2 2'/><Transform DEF='Far' translation='50 0 0'/>")) {
      fixture.watch("P", "isActive");
      fixture.step(0, 50, 0, 0);
      fixture.send("Far", "children", List.of(fixture.node("P")));
      fixture.step(1, 50, 0, 0);
      fixture.send("Far", "children", List.of());
      fixture.step(2, 50, 0, 0);

      assertThat(fixture.log).containsExactly("1.00 P.isActive=true", "2.00 P.isActive=false");
    }
  }
}

package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.sound.Voice;
import org.selectiverenderer.testing.Eventually;

/** Tests which of a scene's sounds are audible in a frame. */
class SceneVoicesTest {
  /** Two seconds of silence, eight samples each. */
  private static final String WAV =
      "data:audio/wav;base64,UklGRjQAAABXQVZFZm10IBAAAAABA"
          + "AEACAAAAAgAAAABAAgAZGF0YRAAAACAgICAgICAgICAgICAgICA";

  /** One second of the same. */
  private static final String SHORT =
      "data:audio/wav;base64,UklGRiwAAABXQVZFZm10IBAAAAABAAE"
          + "ACAAAAAgAAAABAAgAZGF0YQgAAACAgICAgICAgA==";

  private static WorldFixture sound(String clip) {
    return new WorldFixture(
        """
        <Switch DEF='SWITCH' whichChoice='0'>
          <Transform DEF='PLACE' translation='10 0 0'>
            <Sound DEF='SOUND' intensity='0.5' priority='0.25'>
              <AudioClip DEF='CLIP' %s url='"%s"'/>
            </Sound>
          </Transform>
        </Switch>
        """
            .formatted(clip, WAV));
  }

  private static List<Voice> at(WorldFixture fixture, double time, double x) {
    fixture.world.step(time, (viewer, now, dt) -> viewer.moveTo(new Vector3d(x, 0, 0)));
    return fixture.world.voices();
  }

  @Test
  void theViewersPlaceTellsTheGainOfEachEar() {
    try (WorldFixture fixture = sound("startTime='1' pitch='2' gain='0.5'")) {
      assertThat(at(fixture, 0, 10)).isEmpty();
      Voice near = at(fixture, 1.25, 10).get(0);
      assertThat(near.left()).isEqualTo(0.25);
      assertThat(near.right()).isEqualTo(0.25);
      assertThat(near.position()).isEqualTo(0.5, within(1e-9));
      assertThat(near.pitch()).isEqualTo(2);
      assertThat(near.recording().seconds()).isEqualTo(2);
      assertThat(near.rank().priority()).isEqualTo(0.25);
      Voice far = at(fixture, 1.5, 4.5).get(0);
      assertThat(far.source()).isSameAs(near.source());
      assertThat(far.left()).isZero();
      assertThat(far.right()).isEqualTo(0.25 * Math.pow(10, -0.5), within(1e-9));
      assertThat(at(fixture, 1.75, -1)).isEmpty();
      assertThat(at(fixture, 2, 10)).isEmpty();
    }
  }

  @Test
  void whatIsHiddenDisabledOrPausedIsNotHeard() {
    try (WorldFixture fixture = sound("loop='true'")) {
      assertThat(at(fixture, 1, 10)).hasSize(1);
      fixture.send("SWITCH", "whichChoice", -1);
      at(fixture, 2, 10);
      assertThat(at(fixture, 3, 10)).isEmpty();
      fixture.send("SWITCH", "whichChoice", 0);
      at(fixture, 4, 10);
      assertThat(at(fixture, 5, 10)).hasSize(1);
      fixture.send("SOUND", "enabled", false);
      assertThat(at(fixture, 6, 10)).isEmpty();
      fixture.send("SOUND", "enabled", true);
      fixture.send("CLIP", "pauseTime", 6.5);
      assertThat(at(fixture, 7, 10)).isEmpty();
    }
  }

  private static Object duration(WorldFixture fixture) {
    return fixture.node("CLIP").value(fixture.node("CLIP").type().indexOf("duration_changed"));
  }

  /** Steps until the clip lasts so long. */
  private static void awaitDuration(WorldFixture fixture, double seconds) {
    Eventually.await(
        () -> "a clip of " + seconds + " s; it lasts " + duration(fixture),
        () -> {
          at(fixture, fixture.world.time() + 0.01, 10);
          return Objects.equals(duration(fixture), seconds);
        });
  }

  /** Waits until all files that were asked for are read; no more can be. */
  private static void awaitAllRead(WorldFixture fixture) {
    fixture.loader.close();
    Eventually.await(
        "the end of the loader's threads",
        () ->
            Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().startsWith("scene-loader-")));
  }

  @Test
  void aClipThatComesBackWithAnotherUrlIsReadAnew() {
    try (WorldFixture fixture = sound("loop='true'")) {
      at(fixture, 1, 10);
      awaitDuration(fixture, 2);
      fixture.send("PLACE", "children", List.of());
      at(fixture, 2, 10);
      fixture.send("CLIP", "url", new String[] {SHORT});
      at(fixture, 3, 10);
      fixture.send("PLACE", "children", List.of(fixture.node("SOUND")));
      at(fixture, 4, 10);
      awaitDuration(fixture, 1);
    }
  }

  @Test
  void whatArrivesForAClipThatHasLeftIsNotWhatItPlaysLater() {
    try (WorldFixture fixture = sound("loop='true'")) {
      at(fixture, 1, 10);
      String[] first = fixture.node("CLIP").strings("url");
      fixture.send("CLIP", "url", new String[] {SHORT});
      at(fixture, 2, 10);
      fixture.send("PLACE", "children", List.of());
      at(fixture, 3, 10);
      fixture.send("CLIP", "url", first.clone());
      at(fixture, 3.5, 10);
      fixture.send("PLACE", "children", List.of(fixture.node("SOUND")));
      at(fixture, 4, 10);
      awaitDuration(fixture, 2);
      awaitAllRead(fixture);
      at(fixture, 10, 10);
      at(fixture, 10.5, 10);
      assertThat(duration(fixture)).isEqualTo(2.0);
    }
  }

  @Test
  void aClipAtRestLeavesItsSoundAtRest() {
    try (WorldFixture fixture = sound("startTime='-5'")) {
      at(fixture, 1, 10);
      assertThat(((SleepableNode) fixture.node("SOUND")).awake()).isFalse();
      fixture.send("CLIP", "startTime", 2.0);
      assertThat(((SleepableNode) fixture.node("SOUND")).awake()).isTrue();
      assertThat(at(fixture, 2, 10)).hasSize(1);
      at(fixture, 9, 10);
      at(fixture, 10, 10);
      assertThat(((SleepableNode) fixture.node("SOUND")).awake()).isFalse();
    }
  }

  @Test
  @Timeout(60)
  void anotherUrlBringsAnotherRecording() {
    try (WorldFixture fixture = sound("loop='true'")) {
      assertThat(at(fixture, 1, 10)).hasSize(1);
      fixture.send("CLIP", "load", false);
      at(fixture, 2, 10);
      assertThat(at(fixture, 3, 10)).isEmpty();
      fixture.watch("CLIP", "duration_changed");
      fixture.send("CLIP", "load", true);
      Eventually.await(
          "the recording",
          () -> {
            at(fixture, fixture.world.time() + 1e-4, 10);
            return !fixture.log.isEmpty();
          });
      assertThat(fixture.log.get(0)).endsWith("duration_changed=2.0");
      assertThat(fixture.problems.list()).isEmpty();
    }
  }

  @Test
  void theSoundtrackOfAMovieIsHeardWhileItRunsForwards() {
    Path movies = Path.of("modules/browser/src/test/resources/org/selectiverenderer/browser/movie");
    String scene =
        """
        <Sound><MovieTexture DEF='MOVIE' containerField='source' %s startTime='1' gain='0.5' url='"%s"'/></Sound>
        """;
    try (WorldFixture fixture = new WorldFixture(movies, scene.formatted("", "tone.mpg"))) {
      assertThat(fixture.problems.list()).isEmpty();
      assertThat(at(fixture, 0, 0)).isEmpty();
      Voice voice = at(fixture, 1.25, 0).get(0);
      assertThat(voice.position()).isEqualTo(0.25, within(1e-9));
      assertThat(voice.left()).isEqualTo(0.5);
      assertThat(voice.recording().rate()).isEqualTo(44_100);
      assertThat(voice.recording().seconds()).isEqualTo(0.4, within(0.1));
      assertThat(at(fixture, 2, 0)).isEmpty();
    }
    try (WorldFixture fixture =
        new WorldFixture(movies, scene.formatted("speed='-1'", "tone.mpg"))) {
      at(fixture, 0, 0);
      assertThat(at(fixture, 1.25, 0)).isEmpty();
    }
    try (WorldFixture fixture = new WorldFixture(movies, scene.formatted("", "mandelbrot.m1v"))) {
      assertThat(fixture.problems.list().toString())
          .contains("mandelbrot.m1v has no sound of MPEG audio; the Sound stays silent");
    }
  }
}

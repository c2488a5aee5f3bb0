package org.selectiverenderer.app.headset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.app.run.RunCancellation;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * A run on a real runtime, Monado with its simulated headset, which {@code .ci/openxr} sets up: the
 * head moves, enters an area, both eyes see a mark where they must; the runtime is killed in the
 * middle and started again. A program of its own, as it needs another system than the other tests.
 */
final class MonadoCheck implements RunListener, HeadSampleListener {
  private static final int FRAMES = 300;
  private static final int KILLED_AT = 150;
  private static final int UNAVAILABLE = 75;

  /** A lit red square of 10 cm, two metres in front of the eyes of one who stands in the middle. */
  private static final Vector3d MARK = new Vector3d(0.1, 1.7, -2);

  private static final String SCENE =
      """
      <X3D version='4.0' profile='Immersive'><Scene>
      <NavigationInfo headlight='false'/><Viewpoint position='0 1.6 0'/>
      <Transform translation='0 -0.05 0'><Shape><Box size='20 0.1 20'/></Shape></Transform>
      <Transform translation='%s %s %s'><Shape><Appearance><Material diffuseColor='0 0 0'
      emissiveColor='1 0 0'/></Appearance><Box size='0.1 0.1 0.001'/></Shape></Transform>
      <ProximitySensor DEF='RIGHT' center='5 0 0' size='10 10 10'>
      <MetadataSet name='RIGHT'><MetadataString containerField='value' name='enterTimeSchema'
      value='"OfficeSchema"'/></MetadataSet></ProximitySensor>
      </Scene></X3D>
      """;

  private final HeadsetViewSettings shown = HeadsetViewSettings.standing();
  private final RunCancellation stop = new RunCancellation();
  private final List<HeadSample> samples = new ArrayList<>();
  private final List<HeadsetEvent.Kind> news = new ArrayList<>();
  private final List<String> entered = new ArrayList<>();
  private @Nullable Process runtime;

  /** Exits with 0 when all is as it must be, with 75 when the runtime itself does not start. */
  public static void main(String[] args) throws Exception {
    LibraryProperties.set();
    MonadoCheck check = new MonadoCheck();
    try {
      check.start();
    } catch (IOException | IllegalStateException e) {
      System.out.println("OpenXR: " + e.getMessage());
      System.exit(UNAVAILABLE);
    }
    check.check(Path.of(args[0]));
    System.out.println("OpenXR: all is as it must be");
  }

  private void check(Path folder) throws Exception {
    Path scene = folder.resolve("openxr.x3d");
    Files.writeString(scene, SCENE.formatted(MARK.x, MARK.y, MARK.z));
    try {
      RunSettings settings =
          new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
              .muted(true)
              .with(DisplaySettings.of(DisplayConfiguration.in(shown)))
              .with(
                  new TrackerSettings(
                      new TrackerSpec.Headset(), TrackerOptions.NONE, WhenLost.FREEZE),
                  Optional.empty());
      RunResult result = SceneRunner.inHeadset(settings, HeadsetConnection.find(shown), this, stop);
      judge(result);
      result.screenshot().orElseThrow().writePng(folder.resolve("openxr.png"));
    } finally {
      if (runtime != null) {
        runtime.destroyForcibly();
      }
    }
  }

  /** Starts the service, and waits until it listens. */
  private void start() throws IOException {
    Path socket = Path.of(System.getenv("XDG_RUNTIME_DIR"), "monado_comp_ipc");
    Files.deleteIfExists(socket);
    ProcessBuilder command = new ProcessBuilder("monado-service");
    command.redirectOutput(ProcessBuilder.Redirect.DISCARD);
    command.redirectError(ProcessBuilder.Redirect.DISCARD);
    runtime = command.start(); // Lives as long as its standard input.
    Process service = runtime;
    Eventually.await(
        "monado-service to listen",
        () -> {
          require(service.isAlive(), "monado-service ends at once");
          return Files.exists(socket);
        });
  }

  private static void require(boolean right, String wrong) {
    if (!right) {
      throw new IllegalStateException(wrong);
    }
  }

  private void judge(RunResult result) {
    require(samples.size() >= FRAMES, "only " + samples.size() + " frames");
    double left = samples.stream().mapToDouble(HeadSample::x).min().orElseThrow();
    double right = samples.stream().mapToDouble(HeadSample::x).max().orElseThrow();
    double most = samples.stream().mapToDouble(HeadSample::yaw).max().orElseThrow();
    double least = samples.stream().mapToDouble(HeadSample::yaw).min().orElseThrow();
    require(right - left > 0.01 && right - left < 1, "the head went from " + left + " to " + right);
    require(most - least > 1, "the head turned from " + least + " to " + most);
    require(entered.contains("RIGHT"), "the head entered " + entered);
    require(
        news.containsAll(List.of(HeadsetEvent.Kind.WORN, HeadsetEvent.Kind.LOST))
            && news.lastIndexOf(HeadsetEvent.Kind.WORN) > news.indexOf(HeadsetEvent.Kind.LOST),
        "the headset was " + news);
    Screenshot picture = result.screenshot().orElseThrow();
    for (int eye = 0; eye < 2; eye++) {
      Vector2d seen = seen(picture, eye);
      Vector2d expected = expected(picture, eye);
      require(
          seen.distance(expected) < 1.5,
          "eye %d sees the mark at %s, not at %s".formatted(eye, seen, expected));
    }
    System.out.printf(
        "frames %d, head %.3f to %.3f m, yaw %.1f to %.1f degrees, mark at %s and %s%n",
        samples.size(), left, right, least, most, seen(picture, 0), seen(picture, 1));
  }

  /** Where the middle of what is red lies in an eye's half, in pixels from its upper left. */
  private static Vector2d seen(Screenshot picture, int eye) {
    int half = picture.width() / 2;
    Vector2d sum = new Vector2d();
    int count = 0;
    for (int y = 0; y < picture.height(); y++) {
      for (int x = 0; x < half; x++) {
        int color = picture.rgb(eye * half + x, picture.height() - 1 - y);
        if ((color >> 16 & 0xff) > 128 && (color >> 8 & 0xff) < 64) {
          sum.add(x + 0.5, y + 0.5);
          count++;
        }
      }
    }
    require(count > 0, "eye " + eye + " sees no mark");
    return sum.div(count);
  }

  /** The same, computed from what the runtime told of the eyes and from the last pose. */
  private Vector2d expected(Screenshot picture, int eye) {
    HeadSample last = samples.get(samples.size() - 1);
    Quaterniond turn =
        Viewer.orientation(
            Math.toRadians(last.yaw()), Math.toRadians(last.pitch()), Math.toRadians(last.roll()));
    HeadsetLayout.EyeAt at = shown.layout().eyes().get(eye);
    Matrix4d world =
        new Matrix4d()
            .translationRotate(new Vector3d(last.x(), last.y(), last.z()), turn)
            .translate(at.position())
            .rotate(new Quaterniond(at.orientation()));
    Vector2d seen =
        at.frustum().project(world.invertAffine().transformPosition(MARK, new Vector3d()));
    return new Vector2d(
        (1 + seen.x) / 2 * (picture.width() / 2.0), (1 - seen.y) / 2 * picture.height());
  }

  @Override
  public void scene(HeadLogMetadata description) {
    // Only the frames count.
  }

  @Override
  public void sampled(HeadSample sample, long nanos) {
    samples.add(sample);
    if (samples.size() == KILLED_AT && runtime != null) {
      runtime.destroyForcibly();
    }
    if (samples.size() >= FRAMES) {
      stop.stop();
    }
  }

  @Override
  public void headset(HeadsetEvent told) {
    System.out.println("OpenXR: " + told.text());
    news.add(told.kind());
    if (told.kind() == HeadsetEvent.Kind.LOST) {
      try {
        start();
      } catch (IOException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  @Override
  public void problem(Problem problem) {
    System.out.println(problem);
  }

  @Override
  public void happened(TimelineEvent event) {
    if (event instanceof TimelineEvent.ControllerEvent told
        && told.event() instanceof ControlEvent.Enter enter) {
      entered.add(enter.sensor());
    }
  }

  @Override
  public Optional<HeadSampleListener> samples() {
    return Optional.of(this);
  }

  @Override
  public void printed(String text) {
    System.out.println(text);
  }
}

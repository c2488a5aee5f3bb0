package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.render.AntiAliasing;
import org.selectiverenderer.runtime.render.mark.MarkedView;
import org.selectiverenderer.runtime.viewer.Pose;
import org.selectiverenderer.runtime.walk.Controls;
import org.selectiverenderer.runtime.walk.MouseMapping;
import org.selectiverenderer.runtime.walk.NavigationCommand;

/**
 * What the preview shows and how: outlives the states of the document that it shows one after the
 * other. Belongs to the preview's thread.
 */
final class PreviewStage implements AutoCloseable {
  /** Seconds of a frame of the walk at most, so that nobody jumps after a pause. */
  private static final double LONGEST = 0.25;

  private final StagePainter painter;
  private final int motionSamples = AntiAliasing.forMotion();
  private final StageEye eye = new StageEye();
  private final Controls controls = new Controls(MouseMapping.WALK);
  private @Nullable PreviewScene scene;
  private int whole;
  private int width;
  private final VersionChoice versions = new VersionChoice();
  private int height;
  private List<Anchor> selection = List.of();
  private List<String> schemas = List.of();
  private boolean changed;

  /** Whether the picture stays, and something else is to be said about it. */
  private boolean told;

  private @Nullable PreviewFrame last;
  private @Nullable Camera camera;
  private boolean rough;

  PreviewStage(MarkedView view) {
    painter = new StagePainter(view);
  }

  /** Whether frames follow each other without being asked for. */
  boolean moving() {
    return scene != null && scene.walking().isPresent();
  }

  /** Whether the frame drawn last, in a hurry, is to be followed by a smoother one. */
  boolean rough() {
    return rough;
  }

  /** Something is to be drawn anew. */
  void changed() {
    changed = true;
  }

  void size(int newWidth, int newHeight) {
    whole = newWidth;
    width = moving() ? newWidth : painter.compared().width(newWidth);
    height = newHeight;
    eye.size(width, height);
  }

  /** Shows another state of the document; the viewer stays where it is. */
  void show(LoadedPreview loaded) {
    boolean walked = moving();
    Optional<Pose> before = Optional.ofNullable(scene).map(PreviewScene::pose);
    if (scene != null) {
      scene.close();
    }
    PreviewScene shown = new PreviewScene(loaded);
    scene = shown;
    shown.asIf(schemas);
    versions.apply(shown);
    if (before.isEmpty()) {
      home();
    } else if (walked) {
      shown.walk(controls);
      before.get().applyTo(shown.world().viewer());
    }
  }

  /**
   * Takes over what an edit of the text has changed; the viewer stays where it is, and walks on.
   *
   * @return false if that is not possible: the document is to be loaded anew
   */
  boolean patch(ScenePatch patch) {
    PreviewScene of = scene;
    if (of == null || of.revision() >= patch.revision()) {
      return of != null; // A later state has been loaded meanwhile.
    }
    boolean walked = moving();
    Pose before = of.pose();
    of.stand();
    boolean taken = of.patch(patch);
    if (taken && patch.fields().isEmpty() && schemas.isEmpty()) {
      told = true; // Metadata are not seen but in the labels.
    } else {
      changed = true;
    }
    if (walked) {
      of.walk(controls);
      before.applyTo(of.world().viewer());
    }
    return taken;
  }

  /** To the start viewpoint, or so that the whole scene is seen where there is none. */
  void home() {
    if (scene != null) {
      eye.home(scene);
    }
  }

  /** To another viewpoint, counted from the bound one. */
  void viewpoint(int steps) {
    if (scene != null && !moving()) {
      scene.world().views().goToViewpoint(steps);
      eye.stay(scene);
    }
  }

  /** Brings what is selected into view. */
  void frameSelected() {
    if (scene != null && !moving()) {
      eye.frame(scene, selection);
    }
  }

  /** The author's eye, for turning, shifting and coming nearer. */
  Orbit orbit() {
    return eye.orbit();
  }

  /** Turns about what is under a pixel from now on, if anything is. */
  void grab(int x, int y) {
    if (scene != null) {
      eye.cast(scene, x, y).ifPresent(hit -> eye.orbit().pivot(hit.point()));
    }
  }

  /** Says to the scene of a walk which pixel the pointer is over. */
  void point(int x, int y) {
    if (scene != null) {
      eye.point(scene, x, y);
    }
  }

  /** Where the scene is seen from; empty while there is none. */
  Optional<Pose> pose() {
    return Optional.ofNullable(scene).map(PreviewScene::pose);
  }

  /**
   * Says what an author means by a click on a pixel.
   *
   * @param innermost for the nearest element in any case
   * @return the element's anchor and the revision that it belongs to; empty where nothing is
   */
  Optional<Picked> pick(int x, int y, boolean innermost) {
    PreviewScene of = scene;
    return of == null
        ? Optional.empty()
        : eye.cast(of, x, y)
            .flatMap(hit -> of.nodes().meant(hit.shape(), innermost))
            .map(node -> new Picked(of.nodes().anchor(node), of.revision()));
  }

  /** An element that was clicked on, in the text of a revision. */
  record Picked(Anchor anchor, long revision) {}

  /**
   * What is selected in the document.
   *
   * @param anchors of the element and those around it, the nearest first
   */
  void select(List<Anchor> anchors) {
    changed |= !anchors.equals(selection);
    selection = anchors;
  }

  /** What is shown now; for those who measure it, on this thread. */
  Optional<PreviewScene> scene() {
    return Optional.ofNullable(scene);
  }

  void asIf(List<String> wanted) {
    schemas = wanted;
    if (scene != null) {
      scene.asIf(wanted);
    }
  }

  /** Shows the scene with all polygons too, or not. */
  void compare(CompareMode mode) {
    painter.compare(mode);
    size(whole, height);
  }

  /** Shows another version of the selected object, counted from the present one; 0 for none. */
  void version(int steps) {
    if (scene != null && !moving()) {
      versions.step(scene, selection, steps);
    }
  }

  void sensorsShown(boolean show) {
    painter.sensorsShown(show);
  }

  void wireframe(boolean show) {
    painter.wireframe(show);
  }

  void walk(boolean walk) {
    if (scene == null || walk == moving()) {
      return;
    }
    controls.releaseAll();
    controls.takeCommands();
    if (walk) {
      scene.walk(controls);
    } else {
      scene.stand();
      eye.stay(scene);
    }
    size(whole, height);
  }

  /** Keys and mouse of the walk. */
  Controls controls() {
    return controls;
  }

  /**
   * The next frame.
   *
   * @param seconds since the one before
   * @param hurried whether others are likely to follow at once
   * @return empty when nothing has changed or there is nothing to show
   */
  Optional<PreviewFrame> frame(double seconds, boolean hurried) {
    boolean draw = changed || moving() || rough;
    boolean tell = told;
    changed = false;
    told = false;
    if (scene == null || width <= 0 || height <= 0 || !draw && !tell) {
      return Optional.empty();
    }
    PreviewFrame before = last;
    if (!draw && before != null && camera != null) {
      scene.look(eye.orbit().pose());
      return Optional.of(before.with(painter.labels(scene, selection, camera), scene.revision()));
    }
    if (scene.walking().isPresent()) {
      for (NavigationCommand command : controls.takeCommands()) {
        scene.walking().get().command(command);
      }
      scene.step(Math.min(seconds, LONGEST));
    } else {
      scene.look(eye.orbit().pose());
    }
    int samples = moving() || hurried ? motionSamples : AntiAliasing.SMOOTH;
    rough = !moving() && samples < AntiAliasing.SMOOTH;
    PreviewFrame drawn = painter.draw(scene, selection, !moving(), width, height, samples);
    camera = drawn.camera();
    last = drawn;
    return Optional.of(drawn);
  }

  @Override
  public void close() {
    if (scene != null) {
      scene.close();
      scene = null;
    }
  }
}

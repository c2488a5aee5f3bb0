package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.compare.Compared;
import org.selectiverenderer.runtime.Pointer;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.collide.RayCaster;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.AntiAliasing;
import org.selectiverenderer.runtime.render.mark.MarkedPicture;
import org.selectiverenderer.runtime.render.mark.MarkedView;
import org.selectiverenderer.runtime.render.mark.Marking;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Pose;
import org.selectiverenderer.runtime.walk.Controls;
import org.selectiverenderer.runtime.walk.MouseMapping;
import org.selectiverenderer.runtime.walk.NavigationCommand;

/**
 * What the preview shows and how: outlives the states of the document that it shows one after the
 * other. Belongs to the preview's thread.
 */
final class PreviewStage implements AutoCloseable {
  private static final int OUTLINE = 0xff8c00;

  /** How far ahead the eye turns about something where nothing is in view. */
  private static final double NO_DEPTH = 5;

  /** Seconds of a frame of the walk at most, so that nobody jumps after a pause. */
  private static final double LONGEST = 0.25;

  private final MarkedView view;
  private final int motionSamples = AntiAliasing.forMotion();
  private final Orbit orbit = new Orbit();
  private final Controls controls = new Controls(MouseMapping.WALK);
  private @Nullable PreviewScene scene;
  private int whole;
  private int width;
  private CompareMode compare = CompareMode.OFF;
  private final VersionChoice versions = new VersionChoice();
  private int height;
  private List<Anchor> selection = List.of();
  private List<String> schemas = List.of();
  private boolean sensorsShown = true;
  private boolean wireframe;
  private boolean changed;

  /** Whether the picture stays, and something else is to be said about it. */
  private boolean told;

  private @Nullable PreviewFrame last;
  private @Nullable Camera camera;
  private boolean rough;

  PreviewStage(MarkedView view) {
    this.view = view;
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
    width = moving() ? newWidth : compare.width(newWidth);
    height = newHeight;
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
    if (scene == null) {
      return;
    }
    Optional<Pose> start =
        scene
            .world()
            .bindables()
            .bound("X3DViewpointNode")
            .map(
                bound -> {
                  scene.world().views().goTo(bound);
                  return scene.pose();
                });
    if (start.isPresent()) {
      place(start.get());
    } else {
      scene.look(orbit.pose());
      scene.bounds().ifPresent(orbit::frame);
    }
  }

  /** To another viewpoint, counted from the bound one. */
  void viewpoint(int steps) {
    if (scene != null && !moving()) {
      scene.world().views().goToViewpoint(steps);
      place(scene.pose());
    }
  }

  private void place(Pose pose) {
    scene.look(pose);
    double distance =
        scene.hit(new Vector3d(0, 0, -1)).map(RayCaster.Hit::distance).orElse(NO_DEPTH);
    orbit.place(pose, distance);
  }

  /** Where the scene is seen from; empty while there is none. */
  Optional<Pose> pose() {
    return Optional.ofNullable(scene).map(PreviewScene::pose);
  }

  /** The author's eye, for turning, shifting and coming nearer. */
  Orbit orbit() {
    return orbit;
  }

  /** Turns about what is under a pixel from now on, if anything is. */
  void grab(int x, int y) {
    cast(x, y).ifPresent(hit -> orbit.pivot(hit.point()));
  }

  private Optional<RayCaster.Hit> cast(int x, int y) {
    return scene == null || width == 0 ? Optional.empty() : scene.hit(direction(scene, x, y));
  }

  /** Says to the scene of a walk which pixel the pointer is over. */
  void point(int x, int y) {
    if (scene != null && width > 0 && height > 0) {
      scene
          .world()
          .point(new Pointer(Optional.of(direction(scene, x, y)), false, (double) width / height));
    }
  }

  /** Of the line of sight through the middle of a pixel, in the viewer's frame. */
  private Vector3d direction(PreviewScene of, int x, int y) {
    double half = Math.tan(of.world().viewer().fieldOfView() / 2);
    double smaller = Math.min(width, height);
    double right = (2 * (x % width + 0.5) - width) / smaller * half;
    double up = (height - 2 * (y + 0.5)) / smaller * half;
    return new Vector3d(right, up, -1);
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
        : cast(x, y)
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

  /** Brings what is selected into view. */
  void frameSelected() {
    if (scene != null && !moving()) {
      scene
          .nodes()
          .find(selection)
          .flatMap(scene::bounds)
          .or(scene::bounds)
          .ifPresent(orbit::frame);
    }
  }

  void asIf(List<String> wanted) {
    schemas = wanted;
    if (scene != null) {
      scene.asIf(wanted);
    }
  }

  /** Shows the scene with all polygons too, or not. */
  void compare(CompareMode mode) {
    compare = mode;
    size(whole, height);
  }

  /** Shows another version of the selected object, counted from the present one; 0 for none. */
  void version(int steps) {
    if (scene != null && !moving()) {
      versions.step(scene, selection, steps);
    }
  }

  void sensorsShown(boolean show) {
    sensorsShown = show;
  }

  void wireframe(boolean show) {
    wireframe = show;
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
      place(scene.pose());
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
      scene.look(orbit.pose());
      return Optional.of(before.with(labels(scene, camera), scene.revision()));
    }
    if (scene.walking().isPresent()) {
      for (NavigationCommand command : controls.takeCommands()) {
        scene.walking().get().command(command);
      }
      scene.step(Math.min(seconds, LONGEST));
    } else {
      scene.look(orbit.pose());
    }
    int samples = moving() || hurried ? motionSamples : AntiAliasing.SMOOTH;
    rough = !moving() && samples < AntiAliasing.SMOOTH;
    PreviewFrame drawn = draw(scene, samples);
    last = drawn;
    return Optional.of(drawn);
  }

  private List<PreviewFrame.Label> labels(PreviewScene of, Camera seenBy) {
    Optional<Node> selected = of.nodes().find(selection);
    return sensorsShown ? of.areas().labels(seenBy, selected.orElse(null), of::sees) : List.of();
  }

  private PreviewFrame draw(PreviewScene shown, int samples) {
    Optional<Node> selected = shown.nodes().find(selection);
    Set<ShapeInstance> outlined = selected.map(shown::shapes).orElse(Set.of());
    MarkedPicture picture =
        view.draw(
            shown.world(),
            new Marking(
                sensorsShown ? shown.areas().marks(selected.orElse(null)) : List.of(),
                outlined,
                wireframe,
                Optional.empty()),
            width,
            height,
            samples);
    camera = picture.camera();
    return new PreviewFrame(
        outlined.isEmpty()
            ? PreviewImages.of(picture.pixels())
            : PreviewImages.outlined(picture.pixels(), OUTLINE),
        picture.camera(),
        labels(shown, picture.camera()),
        shown.world().instances().shownPolygons(),
        picture.drawn().triangles(),
        shown.enteredAreas(),
        shown.schemas(),
        shown.walking().isPresent(),
        selected.map(Node::toString),
        (int) shown.world().layers().stream().filter(layer -> !layer.active()).count(),
        shown.revision(),
        view.info().renderer() + ", OpenGL " + view.info().version(),
        compared(shown, samples),
        VersionChoice.words(shown));
  }

  private Optional<Compared> compared(PreviewScene shown, int samples) {
    if (compare == CompareMode.OFF || moving()) {
      return Optional.empty();
    }
    return Optional.of(
        shown.inDetail(
            () -> {
              Marking plain = new Marking(List.of(), Set.of(), wireframe, Optional.empty());
              MarkedPicture all = view.draw(shown.world(), plain, width, height, samples);
              return new Compared(
                  compare,
                  PreviewImages.of(all.pixels()),
                  shown.world().instances().shownPolygons());
            }));
  }

  @Override
  public void close() {
    if (scene != null) {
      scene.close();
      scene = null;
    }
  }
}

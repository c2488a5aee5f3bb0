package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.preview.ScenePreviewRenderer;

/**
 * Controls what the preview shows: holds scene, camera, selection and display options, which
 * outlive the successive states of the document. Confined to the preview's thread.
 */
final class PreviewController implements AutoCloseable {
  /** Seconds after the beginning of a cycle in which it has begun. */
  private static final double BEGUN = 1e-3;

  /** Longest time step of the walk in seconds, so that the viewer does not jump after a pause. */
  private static final double LONGEST = 0.25;

  /** Polygons that a software renderer takes a tenth of a second or more to draw smoothly. */
  private static final long HEAVY = 100_000;

  private final PreviewRenderer painter;
  private final int motionSamples = AntiAliasing.forMotion();
  private final PreviewCameraController eye = new PreviewCameraController();
  private final KeyboardMouseControls controls = new KeyboardMouseControls(MouseButtonMapping.WALK);
  private @Nullable PreviewScene scene;
  private int whole;
  private int width;
  private final VersionOverride versions = new VersionOverride();
  private int height;
  private List<SelectedNode> selection = List.of();
  private List<String> schemas = List.of();
  private boolean changed;
  private boolean playing;

  /** Whether only the labels have to be updated, not the picture. */
  private boolean told;

  private @Nullable PreviewFrame last;
  private @Nullable Camera camera;
  private boolean rough;

  PreviewController(ScenePreviewRenderer view) {
    painter = new PreviewRenderer(view);
  }

  /** Whether frames are drawn continuously: during a walk, and while the animation plays. */
  boolean live() {
    return moving() || playing && scene != null && scene.animation().isPresent();
  }

  /** Lets the scene's time pass, or stand. */
  void play(boolean play) {
    playing = play;
  }

  /**
   * Shows another moment of the animation.
   *
   * @param phase seconds since the beginning of its cycle
   */
  void seek(double phase) {
    if (scene != null && !moving()) {
      PreviewScene of = scene;
      // A sensor is at the end of a cycle, not at the beginning of the next, in the same moment.
      of.animation().ifPresent(now -> of.pass(now.until(Math.max(phase, BEGUN))));
    }
  }

  /** Where the animation stands; empty for a scene without one. */
  Optional<AnimationPhase> animation() {
    return scene == null ? Optional.empty() : scene.animation();
  }

  /** Whether the author walks. */
  boolean moving() {
    return scene != null && scene.walking().isPresent();
  }

  /** Whether the last frame had few samples and a smoother one has to follow. */
  boolean rough() {
    return rough;
  }

  /** Whether a smooth picture of the scene takes so long that a rough one has to come first. */
  boolean heavy() {
    return motionSamples < AntiAliasing.SMOOTH
        && scene != null
        && scene.world().instances().shownPolygons() > HEAVY;
  }

  /** Requests a new frame. */
  void changed() {
    changed = true;
  }

  void size(int newWidth, int newHeight) {
    whole = newWidth;
    width = moving() ? newWidth : painter.compared().width(newWidth);
    height = newHeight;
    eye.size(width, height);
  }

  /** Shows another loaded state of the document; the viewer's pose is kept. */
  void show(LoadedPreview loaded) {
    boolean walked = moving();
    Optional<Pose> before = Optional.ofNullable(scene).map(PreviewScene::pose);
    Optional<AnimationPhase> stood = animation();
    if (scene != null) {
      scene.close();
    }
    PreviewScene shown = new PreviewScene(loaded);
    scene = shown;
    stood.ifPresent(phase -> seek(phase.seconds()));
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
   * Applies what an edit of the text has changed; the viewer's pose and a walk are kept.
   *
   * @param added the new nodes of the patch
   * @return false if that is not possible and the document has to be loaded again
   */
  boolean patch(ScenePatch patch, AddedNodes added) {
    PreviewScene of = scene;
    if (of == null || of.revision() >= patch.revision()) {
      return of != null; // A later state has been loaded meanwhile.
    }
    boolean walked = moving();
    Pose before = of.pose();
    of.stand();
    boolean taken = of.patch(patch, added);
    if (taken && patch.metadataOnly() && schemas.isEmpty()) {
      told = true; // Metadata show in the labels only.
    } else {
      changed = true;
    }
    if (walked) {
      of.walk(controls);
      before.applyTo(of.world().viewer());
    }
    return taken;
  }

  /** Goes to the start viewpoint, or frames the whole scene where there is none. */
  void home() {
    if (scene != null) {
      eye.home(scene);
    }
  }

  /** Goes to another viewpoint, by steps from the bound one. */
  void viewpoint(int steps) {
    if (scene != null && !moving()) {
      scene.world().views().goToViewpoint(steps);
      eye.stay(scene);
    }
  }

  /** Frames the selected node. */
  void frameSelected() {
    if (scene != null && !moving()) {
      eye.frame(scene, selection.stream().map(SelectedNode::anchors).toList());
    }
  }

  /** The orbit camera, for turning, panning and zooming. */
  OrbitCamera orbit() {
    return eye.orbit();
  }

  /** Sets the pivot of the orbit camera to the point under a pixel, if there is one. */
  void grab(int x, int y) {
    if (scene != null) {
      eye.cast(scene, x, y).ifPresent(hit -> eye.orbit().pivot(hit.point()));
    }
  }

  /** Returns the nearest hit of the ray through a pixel. */
  Optional<RayCaster.Hit> cast(int x, int y) {
    return scene == null ? Optional.empty() : eye.cast(scene, x, y);
  }

  /** Tells the walked scene which pixel the pointer is over. */
  void point(int x, int y) {
    if (scene != null) {
      eye.point(scene, x, y);
    }
  }

  /** Returns what is under a pixel, in scene coordinates; empty where nothing is. */
  Optional<Vector3d> hit(int x, int y) {
    PreviewScene of = scene;
    return of == null
        ? Optional.empty()
        : eye.cast(of, x, y).map(found -> new Vector3d(found.point()));
  }

  /** The viewer's pose; empty while there is no scene. */
  Optional<Pose> pose() {
    return Optional.ofNullable(scene).map(PreviewScene::pose);
  }

  /**
   * Returns the element that a click on a pixel selects.
   *
   * @param innermost whether to select the nearest element in any case
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
  record Picked(SourceAnchor anchor, long revision) {}

  /** Sets the selected nodes of the document, in the order of their selection. */
  void select(List<SelectedNode> nodes) {
    changed |= !nodes.equals(selection);
    selection = nodes;
  }

  /** The anchors of the node selected last and of those around it, the nearest first. */
  private List<SourceAnchor> last() {
    return selection.isEmpty() ? List.of() : selection.get(selection.size() - 1).anchors();
  }

  /** The scene; for queries on this thread. */
  Optional<PreviewScene> scene() {
    return Optional.ofNullable(scene);
  }

  void asIf(List<String> wanted) {
    schemas = wanted;
    if (scene != null) {
      scene.asIf(wanted);
    }
  }

  /** Sets how the scene is compared with its full detail. */
  void compare(CompareMode mode) {
    painter.compare(mode);
    size(whole, height);
  }

  /**
   * Shows another version of the selected object, by steps from the present one; 0 for the one that
   * the schemas select.
   */
  void version(int steps) {
    if (scene != null && !moving()) {
      versions.step(scene, last(), steps);
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

  /** The input state of the walk. */
  KeyboardMouseControls controls() {
    return controls;
  }

  /**
   * Draws the next frame.
   *
   * @param seconds time since the previous frame
   * @param hurried whether a picture is wanted soon rather than smooth, as a smoother one follows
   * @return empty when nothing has changed or there is nothing to show
   */
  Optional<PreviewFrame> frame(double seconds, boolean hurried) {
    boolean live = live();
    boolean draw = changed || live || rough;
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
      scene.pass(live ? Math.min(seconds, LONGEST) : 0);
      scene.look(eye.orbit().pose());
    }
    int samples = live || hurried ? motionSamples : AntiAliasing.SMOOTH;
    PreviewFrame drawn = painter.draw(scene, selection, !moving(), width, height, samples);
    rough = !live && drawn.samples() < AntiAliasing.SMOOTH;
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

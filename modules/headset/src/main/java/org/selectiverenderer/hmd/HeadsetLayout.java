package org.selectiverenderer.hmd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Matrix4d;
import org.joml.Quaterniondc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.apparatus.EyeFrustum;
import org.selectiverenderer.apparatus.FieldOfView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.EyeView;
import org.selectiverenderer.browser.camera.HiddenAreaMesh;
import org.selectiverenderer.browser.camera.ViewLayout;

/**
 * The layout of both eyes' views in a headset, whose runtime gives the position, orientation and
 * frustum of each eye anew in each frame. The pictures lie side by side, the left eye's on the
 * left. Belongs to the thread that steps the world.
 */
public final class HeadsetLayout implements ViewLayout {
  /** The field of view until the runtime gives one: 90 degrees. */
  private static final FieldOfView UNKNOWN = new FieldOfView(1, 1);

  /**
   * An eye in the coordinates of the head.
   *
   * @param position metres
   * @param orientation the rotation from the eye's to the head's coordinates
   */
  public record EyeAt(Vector3dc position, Quaterniondc orientation, EyeFrustum frustum) {}

  private List<EyeAt> eyes = List.of();
  private List<float[]> lenses = List.of();
  private final List<Mask> masks = new ArrayList<>();
  private final double size;
  private boolean floor;

  /**
   * @param size the size of the user relative to the scene: with 2 everything appears half as large
   */
  public HeadsetLayout(double size) {
    this.size = size;
  }

  /** Sets the eyes of the frame that is due, the left one first. */
  public void eyes(List<EyeAt> told) {
    eyes = List.copyOf(told);
  }

  /** Returns the eyes as last set; none before the first frame. */
  public List<EyeAt> eyes() {
    return eyes;
  }

  /** The hidden area of an eye's picture and the frustum that it was computed for. */
  private record Mask(EyeFrustum frustum, HiddenAreaMesh part) {}

  /**
   * Sets the hidden area meshes of the lenses, the left one first.
   *
   * @param told per eye the x and y of the corners of triangles, as tangents of angles from its
   *     axis; not modified; empty if the runtime gives none
   */
  public void hidden(List<float[]> told) {
    lenses = List.copyOf(told);
    masks.clear();
  }

  /** Returns the hidden area of an eye's picture, computed when its mesh or frustum changes. */
  private HiddenAreaMesh hidden(int eye, EyeFrustum frustum) {
    if (eye >= lenses.size()) {
      return HiddenAreaMesh.NONE;
    }
    while (masks.size() <= eye) {
      masks.add(mask(masks.size(), frustum));
    }
    if (!masks.get(eye).frustum().equals(frustum)) {
      masks.set(eye, mask(eye, frustum));
    }
    return masks.get(eye).part();
  }

  private Mask mask(int eye, EyeFrustum frustum) {
    float[] lens = lenses.get(eye);
    float[] corners = new float[lens.length];
    for (int i = 0; i + 1 < lens.length; i += 2) {
      Vector2d at = frustum.project(new Vector3d(lens[i], lens[i + 1], -1));
      corners[i] = (float) at.x;
      corners[i + 1] = (float) at.y;
    }
    return new Mask(frustum, new HiddenAreaMesh(corners));
  }

  /** Sets whether the runtime's heights are above the user's floor. */
  public void floor(boolean known) {
    floor = known;
  }

  /** Returns whether the runtime's heights are above the user's floor, as of the last frame. */
  public boolean floor() {
    return floor;
  }

  /** Returns the scene's units per metre of the user. */
  public double unitsPerMetre(World world) {
    return size * StereoLayout.unitsPerMetre(world);
  }

  @Override
  public List<EyeView> views(World world, int width, int height, DepthRange range) {
    double scale = unitsPerMetre(world);
    int half = width / 2;
    List<EyeView> views = new ArrayList<>();
    for (int eye = 0; eye < eyes.size(); eye++) {
      EyeAt at = eyes.get(eye);
      Vector3d place = at.position().mul(scale, new Vector3d());
      double far = range.far() + 2 * place.length();
      Matrix4d beside = new Matrix4d().translationRotate(place, at.orientation()).invertAffine();
      views.add(
          new EyeView(
              new Camera(
                  beside.mul(world.viewer().view()),
                  at.frustum().projection(range.near(), far),
                  eye * half,
                  0,
                  half,
                  height),
              EyeView.Channel.ALL,
              hidden(eye, at.frustum())));
    }
    return views;
  }

  /** Returns the field of view of both eyes together; the wider side counts for both. */
  public FieldOfView bothEyes() {
    if (eyes.isEmpty()) {
      return UNKNOWN;
    }
    double x = 0;
    double y = 0;
    for (EyeAt eye : eyes) {
      EyeFrustum sees = eye.frustum();
      x = Math.max(x, Math.max(-sees.left(), sees.right()));
      y = Math.max(y, Math.max(-sees.bottom(), sees.top()));
    }
    return new FieldOfView(x, y);
  }

  /** Describes the eyes' frusta in a part of a sentence; empty before the first frame. */
  public String describe() {
    if (eyes.isEmpty()) {
      return "";
    }
    EyeFrustum left = eyes.get(0).frustum();
    EyeFrustum right = eyes.get(1).frustum();
    return String.format(
        Locale.ROOT,
        "left eye %s, right eye %s, eyes %.1f mm apart",
        sides(left),
        sides(right),
        1000 * eyes.get(0).position().distance(eyes.get(1).position()));
  }

  private static String sides(EyeFrustum frustum) {
    return String.format(
        Locale.ROOT,
        "%.1f to %.1f by %.1f to %.1f degrees",
        Math.toDegrees(Math.atan(frustum.left())),
        Math.toDegrees(Math.atan(frustum.right())),
        Math.toDegrees(Math.atan(frustum.bottom())),
        Math.toDegrees(Math.atan(frustum.top())));
  }
}

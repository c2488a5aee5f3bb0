package org.selectiverenderer.hmd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.Eye;
import org.selectiverenderer.apparatus.EyeFrustum;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.apparatus.FieldOfView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.testing.RequiresDisplay;

/** Dots of known places, found again in the pictures that are really drawn. */
@RequiresDisplay
class StereoPictureTest {
  private static final double IPD = 0.063;
  private static final int WIDTH = 1280;
  private static final int HEIGHT = 480;
  private static final int HALF = WIDTH / 2;

  /** A red and a green dot; the viewer stands at the origin and looks along -Z. */
  private static String dots(Vector3d red, Vector3d green, double size) {
    return "<Viewpoint position='0 0 0' fieldOfView='0.5'/>"
        + "<NavigationInfo headlight='false'/>"
        + dot(red, "1 0 0", size)
        + dot(green, "0 1 0", size);
  }

  private static String dot(Vector3d at, String color, double size) {
    return "<Transform translation='%s %s %s'><Shape><Appearance><Material diffuseColor='0 0 0' emissiveColor='%s'/></Appearance><Sphere radius='%s'/></Shape></Transform>"
        .formatted(at.x, at.y, at.z, color, size);
  }

  private static Screenshot picture(World world, EyeGeometry eyes, StereoLayout.Arrangement how) {
    try (OffscreenView view =
        OffscreenView.open(WIDTH, HEIGHT, 0, new StereoLayout(eyes, how), ShadingMode.AUTO)) {
      view.draw(world);
      return view.screenshot();
    }
  }

  /** The middle of the pixels of a colour, as x and y from -1 to 1 in a part of the picture. */
  private static double[] find(Screenshot shot, int mask, int left, int width) {
    double x = 0;
    double y = 0;
    int count = 0;
    for (int row = 0; row < shot.height(); row++) {
      for (int column = left; column < left + width; column++) {
        if ((shot.rgb(column, row) & mask) == mask) {
          x += column - left + 0.5;
          y += row + 0.5;
          count++;
        }
      }
    }
    assertThat(count).as("pixels of the colour").isPositive();
    return new double[] {2 * x / count / width - 1, 2 * y / count / shot.height() - 1};
  }

  private static void checkEye(
      Screenshot shot, EyeGeometry eyes, Eye eye, Vector3d point, int mask) {
    double[] found = find(shot, mask, eye == Eye.LEFT ? 0 : HALF, HALF);
    var expected = eyes.frustum(eye).project(new Vector3d(point).sub(eyes.position(eye)));
    assertThat(found[0]).as("x of %s", eye).isCloseTo(expected.x, within(2.0 / HALF));
    assertThat(found[1]).as("y of %s", eye).isCloseTo(expected.y, within(2.0 / HEIGHT));
  }

  @Test
  void eachEyeSeesThePointsWhereGeometryHasThem() {
    Vector3d near = new Vector3d(-0.12, 0.08, -1);
    Vector3d far = new Vector3d(0.6, -0.4, -4);
    EyeGeometry eyes = new EyeGeometry(DisplayProfile.PROVIEW_50, IPD);
    Screenshot shot =
        picture(
            TestWorlds.world(dots(near, far, 0.01)), eyes, StereoLayout.Arrangement.SIDE_BY_SIDE);
    for (Eye eye : Eye.values()) {
      checkEye(shot, eyes, eye, near, 0xff0000);
      checkEye(shot, eyes, eye, far, 0x00ff00);
    }
    double nearDisparity = find(shot, 0xff0000, 0, HALF)[0] - find(shot, 0xff0000, HALF, HALF)[0];
    double farDisparity = find(shot, 0x00ff00, 0, HALF)[0] - find(shot, 0x00ff00, HALF, HALF)[0];
    // Both to the right in the left eye's picture, the near one four times as much.
    assertThat(farDisparity).isCloseTo(IPD / 4 / 0.37305, within(0.004));
    assertThat(nearDisparity).isCloseTo(IPD / 1 / 0.37305, within(0.004));
  }

  @Test
  void partialOverlapAndAnImageAtADistanceAreDrawnAsGeometryHasThem() {
    DisplayProfile profile =
        new DisplayProfile(
            "partial",
            640,
            480,
            FieldOfView.diagonal(60, 640, 480),
            0.8,
            1.5,
            new Vector3d(0, 0.01, 0.02),
            new Vector3d(),
            0,
            1);
    EyeGeometry eyes = new EyeGeometry(profile, IPD);
    Vector3d near = new Vector3d(0.05, 0.1, -0.9);
    Vector3d far = new Vector3d(-0.3, -0.2, -3);
    Screenshot shot =
        picture(
            TestWorlds.world(dots(near, far, 0.01)), eyes, StereoLayout.Arrangement.SIDE_BY_SIDE);
    for (Eye eye : Eye.values()) {
      checkEye(shot, eyes, eye, near, 0xff0000);
      checkEye(shot, eyes, eye, far, 0x00ff00);
    }
  }

  @Test
  void theDistanceOfTheEyesIsTakenToTheScenesUnitAndTheViewpointsScale() {
    EyeGeometry eyes = new EyeGeometry(DisplayProfile.PROVIEW_50, IPD);
    // Centimetres: a point a metre away lies at 100.
    World centimetres =
        TestWorlds.world(
            "<unit category='length' name='centimetre' conversionFactor='0.01'/>",
            dots(new Vector3d(0, 0, -100), new Vector3d(0, 20, -400), 1));
    checkEye(
        picture(centimetres, eyes, StereoLayout.Arrangement.SIDE_BY_SIDE),
        eyes,
        Eye.LEFT,
        new Vector3d(0, 0, -1),
        0xff0000);
    // A viewer ten times as large sees what is ten metres away as another what is one away.
    World giant =
        TestWorlds.world(
            "<Transform scale='10 10 10'><Viewpoint position='0 0 0'/></Transform>"
                + "<NavigationInfo headlight='false'/>"
                + dot(new Vector3d(0, 0, -10), "1 0 0", 0.1));
    checkEye(
        picture(giant, eyes, StereoLayout.Arrangement.SIDE_BY_SIDE),
        eyes,
        Eye.RIGHT,
        new Vector3d(0, 0, -1),
        0xff0000);
  }

  @Test
  void theLeftEyeOfAnAnaglyphIsRedTheRightOneCyan() {
    EyeGeometry eyes = new EyeGeometry(DisplayProfile.DESK, IPD);
    Vector3d point = new Vector3d(0, 0, -1);
    World world =
        TestWorlds.world(
            "<Viewpoint position='0 0 0'/><NavigationInfo headlight='false'/>"
                + dot(point, "1 1 1", 0.01));
    Screenshot shot = picture(world, eyes, StereoLayout.Arrangement.ANAGLYPH);
    // Pictures of 4:3 in the middle of a wider one.
    int left = (WIDTH - 640) / 2;
    double red = find(shot, 0xff0000, left, 640)[0];
    double cyan = find(shot, 0x00ffff, left, 640)[0];
    assertThat(red)
        .isCloseTo(
            eyes.frustum(Eye.LEFT).project(new Vector3d(0.0315, 0, -1)).x, within(2.0 / 640));
    assertThat(cyan)
        .isCloseTo(
            eyes.frustum(Eye.RIGHT).project(new Vector3d(-0.0315, 0, -1)).x, within(2.0 / 640));
    assertThat(red).isGreaterThan(cyan);
  }

  @Test
  void whatTheDisplaysProportionsLeaveFreeIsBlack() {
    World world = TestWorlds.world("<Background skyColor='1 1 1'/><Viewpoint position='0 0 0'/>");
    try (OffscreenView view =
        OffscreenView.open(
            800,
            800,
            0,
            new StereoLayout(
                new EyeGeometry(DisplayProfile.PROVIEW_50, IPD),
                StereoLayout.Arrangement.SIDE_BY_SIDE),
            ShadingMode.AUTO)) {
      view.draw(world);
      Screenshot shot = view.screenshot();
      assertThat(shot.rgb(200, 400)).isEqualTo(0xffffff);
      assertThat(shot.rgb(600, 400)).isEqualTo(0xffffff);
      assertThat(shot.rgb(200, 240)).isZero();
      assertThat(shot.rgb(600, 560)).isZero();
      assertThat(shot.rgb(200, 255)).isEqualTo(0xffffff);
    }
  }

  @Test
  void anObjectThatOnlyOneEyeSeesIsDrawnForIt() {
    DisplayProfile apart =
        new DisplayProfile(
            "hardly overlapping",
            640,
            480,
            FieldOfView.angles(30, 24),
            0.1,
            Double.POSITIVE_INFINITY,
            new Vector3d(),
            new Vector3d(),
            0,
            1);
    EyeGeometry eyes = new EyeGeometry(apart, IPD);
    Vector3d outside = new Vector3d(-0.8, 0, -2);
    Screenshot shot =
        picture(
            TestWorlds.world(dots(outside, new Vector3d(0.8, 0, -2), 0.02)),
            eyes,
            StereoLayout.Arrangement.SIDE_BY_SIDE);
    checkEye(shot, eyes, Eye.LEFT, outside, 0xff0000);
    checkEye(shot, eyes, Eye.RIGHT, new Vector3d(0.8, 0, -2), 0x00ff00);
    for (int column = HALF; column < WIDTH; column++) {
      assertThat(shot.rgb(column, HEIGHT / 2) & 0xff0000).isZero();
    }
  }

  @Test
  void whatTheLensesOfAHeadsetHideIsBlackAndAllElseAsEver() {
    HeadsetLayout layout = new HeadsetLayout(1);
    EyeFrustum frustum = new EyeFrustum(-1, 0.8, -0.9, 1);
    layout.eyes(
        List.of(
            new HeadsetLayout.EyeAt(new Vector3d(-IPD / 2, 0, 0), new Quaterniond(), frustum),
            new HeadsetLayout.EyeAt(new Vector3d(IPD / 2, 0, 0), new Quaterniond(), frustum)));
    World world =
        TestWorlds.world(
            "<Background skyColor='0 0 1 1 0 1' skyAngle='1.5'/>"
                + "<Viewpoint position='0 0 0'/><NavigationInfo headlight='false'/>"
                + dot(new Vector3d(0, 0, -4), "0 1 0", 3.9));
    Screenshot all = shot(world, layout);
    // Only the lower left of the left eye's picture, up to the middle of its sides.
    layout.hidden(List.of(new float[] {-1, -0.9f, -0.1f, -0.9f, -1, 0.05f}, new float[0]));
    Screenshot masked = shot(world, layout);
    for (int y = 2; y < HEIGHT; y += 7) {
      for (int x = 2; x < WIDTH; x += 7) {
        double side = x / (double) (HALF / 2) + y / (double) (HEIGHT / 2);
        if (Math.abs(side - 1) > 0.01) {
          assertThat(masked.rgb(x, y) & 0xffffff)
              .as("pixel %d %d", x, y)
              .isEqualTo(side < 1 ? 0 : all.rgb(x, y) & 0xffffff);
        }
      }
    }
  }

  private static Screenshot shot(World world, HeadsetLayout layout) {
    try (OffscreenView view = OffscreenView.open(WIDTH, HEIGHT, 0, layout, ShadingMode.AUTO)) {
      view.draw(world);
      return view.screenshot();
    }
  }
}

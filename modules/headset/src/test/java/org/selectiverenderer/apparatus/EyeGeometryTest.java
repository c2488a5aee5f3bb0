package org.selectiverenderer.apparatus;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.hmd.DisplayConfiguration;

class EyeGeometryTest {
  private static final double IPD = 0.063;

  private static DisplayProfile display(double overlap, double imageDistance) {
    return new DisplayProfile(
        "test",
        640,
        480,
        FieldOfView.diagonal(50, 640, 480),
        overlap,
        imageDistance,
        new Vector3d(),
        new Vector3d(),
        0,
        1);
  }

  /** How much farther right the left eye sees a point than the right eye does: -1..1 scale. */
  private static double disparity(EyeGeometry eyes, double x, double y, double z) {
    return seen(eyes, Eye.LEFT, x, y, z) - seen(eyes, Eye.RIGHT, x, y, z);
  }

  private static double seen(EyeGeometry eyes, Eye eye, double x, double y, double z) {
    return eyes.frustum(eye).project(new Vector3d(x, y, z).sub(eyes.position(eye))).x;
  }

  @Test
  void fiftyDegreesFromCornerToCornerOfAVgaPicture() {
    FieldOfView field = DisplayProfile.PROVIEW_50.fieldOfView();
    assertThat(field.diagonal()).isCloseTo(50, within(1e-9));
    // tan 25 degrees along the diagonal of a 4 : 3 : 5 triangle.
    assertThat(field.x()).isCloseTo(0.8 * Math.tan(Math.toRadians(25)), within(1e-12));
    assertThat(field.y()).isCloseTo(0.6 * Math.tan(Math.toRadians(25)), within(1e-12));
    assertThat(field.horizontal()).isCloseTo(40.92, within(0.005));
    assertThat(field.vertical()).isCloseTo(31.26, within(0.005));
  }

  @Test
  void theEyesAreHalfTheirDistanceToEachSideOfTheHead() {
    EyeGeometry eyes = new EyeGeometry(DisplayProfile.PROVIEW_50, IPD);
    assertThat(eyes.position(Eye.LEFT)).isEqualTo(new Vector3d(-0.0315, 0, 0));
    assertThat(eyes.position(Eye.RIGHT)).isEqualTo(new Vector3d(0.0315, 0, 0));
  }

  @Test
  void collimatedOpticsOfFullOverlapShowBothEyesTheSameFrustum() {
    EyeGeometry eyes = new EyeGeometry(DisplayProfile.PROVIEW_50, IPD);
    assertThat(eyes.frustum(Eye.LEFT)).isEqualTo(eyes.frustum(Eye.RIGHT));
    assertThat(eyes.frustum(Eye.LEFT).left()).isEqualTo(-eyes.frustum(Eye.LEFT).right());
  }

  @Test
  void theLeftEyeSeesAPointFartherRightTheNearerItIs() {
    EyeGeometry eyes = new EyeGeometry(display(1, Double.POSITIVE_INFINITY), IPD);
    // The pictures are 2 wide where the tangents are 2 tan: IPD / z / tan.
    double half = eyes.profile().fieldOfView().x();
    assertThat(disparity(eyes, 0.1, 0.2, -2)).isCloseTo(IPD / 2 / half, within(1e-12));
    assertThat(disparity(eyes, 0.1, 0.2, -1)).isCloseTo(IPD / 1 / half, within(1e-12));
    assertThat(disparity(eyes, 0, 0, -1e9)).isCloseTo(0, within(1e-8));
  }

  @Test
  void atTheImagesDistanceThereIsNoDisparityAndBeyondItTheSignTurns() {
    EyeGeometry eyes = new EyeGeometry(display(1, 2), IPD);
    double half = eyes.profile().fieldOfView().x();
    assertThat(disparity(eyes, 0.3, -0.1, -2)).isCloseTo(0, within(1e-12));
    assertThat(disparity(eyes, 0, 0, -1)).isCloseTo(IPD * (1 - 0.5) / half, within(1e-12));
    assertThat(disparity(eyes, 0, 0, -4)).isCloseTo(IPD * (0.25 - 0.5) / half, within(1e-12));
    // Off-axis: the left eye's axis is right of its picture's left half.
    assertThat(-eyes.frustum(Eye.LEFT).left()).isLessThan(eyes.frustum(Eye.LEFT).right());
    assertThat(eyes.frustum(Eye.RIGHT).left()).isEqualTo(-eyes.frustum(Eye.LEFT).right());
  }

  @Test
  void thereIsNoVerticalDisparityAnywhere() {
    for (double distance : new double[] {0.7, 2, Double.POSITIVE_INFINITY}) {
      EyeGeometry eyes = new EyeGeometry(display(0.8, distance), IPD);
      Vector3d corner = new Vector3d(0.4, 0.3, -1.3);
      assertThat(
              eyes.frustum(Eye.LEFT).project(corner.sub(eyes.position(Eye.LEFT), new Vector3d())).y)
          .isCloseTo(
              eyes.frustum(Eye.RIGHT)
                  .project(corner.sub(eyes.position(Eye.RIGHT), new Vector3d()))
                  .y,
              within(1e-12));
    }
  }

  @Test
  void partOfThePictureIsForOneEyeOnlyAtItsOuterSide() {
    EyeGeometry eyes = new EyeGeometry(display(0.75, Double.POSITIVE_INFINITY), IPD);
    EyeFrustum left = eyes.frustum(Eye.LEFT);
    EyeFrustum right = eyes.frustum(Eye.RIGHT);
    double width = left.right() - left.left();
    assertThat(right.right() - right.left()).isCloseTo(width, within(1e-12));
    // What both see reaches from the right picture's left side to the left picture's right side.
    assertThat((left.right() - right.left()) / width).isCloseTo(0.75, within(1e-12));
    assertThat(left.left()).isLessThan(right.left());
  }

  @Test
  void anEyeFartherFromTheImageSeesItSmaller() {
    DisplayProfile relief =
        new DisplayProfile(
            "relief",
            640,
            480,
            FieldOfView.angles(40, 30),
            1,
            1,
            new Vector3d(0, 0, 0.1),
            new Vector3d(),
            0,
            1);
    EyeGeometry eyes = new EyeGeometry(relief, IPD);
    assertThat(eyes.frustum(Eye.LEFT).top())
        .isCloseTo(eyes.frustum(Eye.RIGHT).top() / 1.1, within(1e-12));
    assertThat(eyes.position(Eye.LEFT).z).isEqualTo(0.1);
  }

  @Test
  void theProjectionDrawsWhatTheFrustumSays() {
    EyeFrustum frustum = new EyeGeometry(display(0.8, 1.5), IPD).frustum(Eye.LEFT);
    Vector3d point = new Vector3d(0.2, -0.15, -1.1);
    Vector3d clip = frustum.projection(0.1, 50).transformProject(new Vector3d(point));
    assertThat(clip.x).isCloseTo(frustum.project(point).x, within(1e-12));
    assertThat(clip.y).isCloseTo(frustum.project(point).y, within(1e-12));
    assertThat(clip.z).isBetween(-1.0, 1.0);
  }

  @Test
  void bothEyesSeeMoreThanOneWhereTheirPicturesOverlapInPart() {
    EyeGeometry full = new EyeGeometry(display(1, Double.POSITIVE_INFINITY), 0.063);
    EyeGeometry part = new EyeGeometry(display(0.5, Double.POSITIVE_INFINITY), 0.063);
    double x = full.profile().fieldOfView().x();
    assertThat(full.bothEyes().x()).isEqualTo(x);
    assertThat(part.bothEyes().x()).isCloseTo(1.5 * x, within(1e-12));
    assertThat(part.bothEyes().y()).isEqualTo(full.bothEyes().y());
  }

  @Test
  void theFieldOfAWindowIsTheWiderOneAcrossWhereItIsBroad() {
    DisplayConfiguration window =
        new DisplayConfiguration(
            DisplayMode.WINDOW,
            new EyeGeometry(display(1, Double.POSITIVE_INFINITY), 0.063),
            false);
    FieldOfView seen = window.seen(Math.toRadians(45), 1600, 900);
    assertThat(seen.vertical()).isCloseTo(45, within(1e-9));
    assertThat(seen.x()).isCloseTo(16.0 / 9 * seen.y(), within(1e-12));
  }
}

package org.selectiverenderer.x3d.geodesy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SpatialReferenceSystemTest {
  private static final double[] NORTH_SEA = {
    53 + 48 / 60.0 + 33.820 / 3600, 2 + 7 / 60.0 + 46.380 / 3600, 73
  };

  private static SpatialReferenceSystem system(String... words) {
    return SpatialReferenceSystem.of(words);
  }

  /** The example of IOGP Guidance Note 373-7-2 for EPSG method 9602. */
  @Test
  void geodeticCoordinatesBecomeGeocentric() {
    Vector3d at = system("GD", "WE").geocentric(NORTH_SEA[0], NORTH_SEA[1], NORTH_SEA[2]);

    assertThat(at.x).isEqualTo(3771793.968, within(0.001));
    assertThat(at.y).isEqualTo(140253.342, within(0.001));
    assertThat(at.z).isEqualTo(5124304.349, within(0.001));
  }

  @Test
  void geocentricCoordinatesBecomeGeodeticAnywhere() {
    SpatialReferenceSystem system = system("GD", "WE");
    for (double[] at :
        new double[][] {
          NORTH_SEA, {0, 0, 0}, {90, 0, 10}, {-90, 0, 0}, {-33.9, 151.2, -400}, {60, -179.5, 4e7}
        }) {
      double[] back = system.coordinates(system.geocentric(at[0], at[1], at[2]));

      assertThat(back[0]).isEqualTo(at[0], within(1e-9));
      assertThat(back[1]).isEqualTo(at[1], within(1e-9));
      assertThat(back[2]).isEqualTo(at[2], within(1e-4));
    }
  }

  /**
   * The CN Tower in Toronto: zone 17, 630084 m east, 4833438 m north, 43.642567 N 79.387139 W
   * (Wikipedia, Universal Transverse Mercator coordinate system).
   */
  @Test
  void utmIsNorthingThenEasting() {
    Vector3d utm = system("UTM", "Z17", "WE").geocentric(4833438, 630084, 76);
    Vector3d geodetic = system("GD", "WE").geocentric(43.642567, -79.387139, 76);

    assertThat(utm.distance(geodetic)).isLessThan(1);
    assertThat(system("UTM", "Z17", "easting_first").geocentric(630084, 4833438, 76))
        .isEqualTo(utm);
  }

  @Test
  void utmIsTakenBackInBothHemispheres() {
    for (String[] words : new String[][] {{"UTM", "Z33"}, {"UTM", "Z56", "S"}}) {
      SpatialReferenceSystem system = system(words);
      double[] back = system.coordinates(system.geocentric(6250000, 334000, 12));

      assertThat(back[0]).isEqualTo(6250000, within(1e-4));
      assertThat(back[1]).isEqualTo(334000, within(1e-4));
      assertThat(back[2]).isEqualTo(12, within(1e-4));
    }
  }

  /** On the central meridian the northing is the length of the meridian times 0.9996. */
  @Test
  void aQuarterOfTheMeridianIsItsKnownLength() {
    double[] pole = system("UTM", "Z31", "WE").coordinates(new Vector3d(1e-3, 0, 6356752.314));

    // 10 001 965.729 m on WGS 84.
    assertThat(pole[0] / 0.9996).isEqualTo(10001965.729, within(0.01));
  }

  @Test
  void ellipsoidsDiffer() {
    assertThat(system("GD", "CC").geocentric(0, 0, 0).x).isEqualTo(6378206.4);
    assertThat(system("GD", "AA").geocentric(0, 90, 0).y).isEqualTo(6377563.396, within(1e-6));
  }

  @Test
  void whatIsNotKnownIsSaid() {
    assertThat(system("GD", "WE").problem()).isEmpty();
    assertThat(system("GD", "XX").problem().orElseThrow()).contains("\"XX\"");
    assertThat(system("GD", "WGS84").problem().orElseThrow()).contains("geoid");
    assertThat(system("UTM").problem().orElseThrow()).contains("zone");
  }
}

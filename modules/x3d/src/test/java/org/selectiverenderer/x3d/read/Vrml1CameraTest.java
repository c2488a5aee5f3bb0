package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;

import org.junit.jupiter.api.Test;

/** Cameras of VRML 1.0, backgrounds and navigation, and what its Info nodes say to viewers. */
class Vrml1CameraTest {
  @Test
  void theCamerasOfASwitchAreViewpointsOfWhichTheChosenOneIsFirst() {
    assertThat(
            lines(
                """
                DEF Cameras Switch {
                  whichChild 1
                  DEF Front PerspectiveCamera { position 0 0 9 heightAngle 0.5 }
                  DEF Top OrthographicCamera { position 0 9 0 orientation 1 0 0 -1.57 height 6 }
                }
                Cube {}
                """))
        .containsSequence(
            "OrthoViewpoint DEF=Top description=Top position=0 9 0 orientation=1 0 0 -1.57 "
                + "fieldOfView=-3 -3 3 3",
            "Viewpoint DEF=Front description=Front position=0 0 9 fieldOfView=0.5");
  }

  @Test
  void informationOfViewersIsRead() {
    assertThat(
            lines(
                "DEF BackgroundColor Info { string \"0.1 0.2 0.3\" } DEF Viewer Info { string"
                    + " \"examiner\" } Info { string \"made by hand\" }"))
        .containsExactly(
            "Background DEF=BackgroundColor skyColor=0.1 0.2 0.3",
            "NavigationInfo DEF=Viewer type=\"EXAMINE\" \"ANY\"",
            "WorldInfo info=\"made by hand\"");
  }

  @Test
  void theBackgroundFogAndNavigationThatCastleAllowsAreThoseOfVrml97() {
    assertThat(
            lines(
                """
                DEF Sky Background { skyColor [ 0 1 1, 0 0 0.5 ] skyAngle [ 1.57 ] backUrl "back.png"
                                     frontUrl [ "a.png", "b.png" ] }
                Fog { color 0 0.5 0 visibilityRange 160 fogType "EXPONENTIAL" }
                NavigationInfo { headlight FALSE type [ "WALK", "ANY" ] speed 2 avatarSize [] }
                PointLight { location 0 0 0 }
                Sphere {}
                """))
        .startsWith(
            "Background DEF=Sky skyColor=0 1 1, 0 0 0.5 skyAngle=1.57 backUrl=\"back.png\" "
                + "frontUrl=\"a.png\", \"b.png\"",
            "Fog color=0 0.5 0 visibilityRange=160 fogType=EXPONENTIAL",
            "NavigationInfo headlight=false type=\"WALK\", \"ANY\" speed=2 avatarSize=",
            "PointLight location=0 0 0 global=false radius=1000000",
            "Shape");
  }
}

package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.scene;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.tessellate.TransformMatrix;

/** Transformations of VRML 1.0, which follow one another, as Transforms of X3D. */
class Vrml1TransformTest {
  private final ReaderFixture fixture = new ReaderFixture();

  @Test
  void aTransformationMovesWhatFollowsUpToTheEndOfTheSeparator() {
    assertThat(
            lines(
                """
                Separator {
                  Translation { translation 1 2 3 } Cube { width 4 }
                  Translation { translation 0 1.5 0 } Sphere { radius 2 }
                }
                Cone {}
                """))
        .containsExactly(
            "Transform translation=1 2 3",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box size=4 2 2",
            " Transform translation=0 1.5 0",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere radius=2",
            "Shape",
            " Appearance",
            "  Material",
            " Cone");
  }

  @Test
  void translationRotationAndScaleInThisOrderAreOneTransform() {
    assertThat(
            lines(
                "Separator { Translation { translation 1 0 0 } Rotation { rotation 0 1 0 1.57 }"
                    + " Scale { scaleFactor 1 2 1 } Cylinder { height 3 } }"))
        .startsWith(
            "Transform translation=1 0 0 rotation=0 1 0 1.57 scale=1 2 1", " Shape", "  Appearance")
        .endsWith("  Cylinder height=3");
  }

  @Test
  void otherOrdersOfTransformationsBecomeOneMatrix() {
    assertThat(
            lines(
                "Separator { Rotation { rotation 0 0 1 1.5707963 } Translation { translation 1 0 0"
                    + " } Sphere {} }"))
        .startsWith("Transform translation=0 1 0 rotation=0 0 1 1.5707963");
    assertThat(
            lines(
                "Separator { MatrixTransform { matrix 2 0 0 0 0 3 0 0 0 0 4 0 5 6 7 1 } Sphere {}"
                    + " }"))
        .startsWith("Transform translation=5 6 7 scale=2 3 4");
    assertThat(
            lines(
                "Separator { Transform { translation 1 2 3 center 1 0 0 scaleOrientation 0 1 0 1"
                    + " scaleFactor 1 2 3 } Sphere {} }"))
        .startsWith(
            "Transform translation=1 2 3 center=1 0 0 scaleOrientation=0 1 0 1 scale=1 2 3");
  }

  @Test
  void aMatrixThatShearsKeepsItsShear() {
    X3dFile file =
        scene(
            fixture,
            "Separator { MatrixTransform { matrix 1 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 } Cube {} }");
    fixture.assertClean();
    ParsedNode transform = file.nodes().get(0);
    Vector3d moved =
        TransformMatrix.of(transform, new Matrix4d()).transformPosition(new Vector3d(0, 1, 0));
    assertThat(moved.distance(1, 1, 0)).isLessThan(1e-5);
  }
}

package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.scene;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * How nodes of VRML 1.0 change the state that counts for what follows, and how USE repeats that.
 */
class Vrml1StateTest {
  private final ReaderFixture fixture = new ReaderFixture();

  @Test
  void aTransformSeparatorKeepsTheMaterialAndAGroupKeepsAll() {
    assertThat(
            lines(
                """
                TransformSeparator { Translation { translation 1 0 0 } Material { diffuseColor 1 0 0 } }
                Group { Translation { translation 0 2 0 } }
                Sphere {}
                """))
        .containsExactly(
            "Transform translation=0 2 0",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=1 0 0",
            "  Sphere");
  }

  @Test
  void aMaterialCountsForWhatFollowsAndIsSharedByItsName() {
    assertThat(
            lines(
                "Material { diffuseColor 1 0 0 shininess 0.5 transparency .25 } Cube {} Sphere {}"))
        .containsExactly(
            "Shape",
            " Appearance DEF=Appearance_1",
            "  Material diffuseColor=1 0 0 shininess=0.5 transparency=.25",
            " Box",
            "Shape",
            " Appearance USE=Appearance_1",
            " Sphere");
  }

  @Test
  void aSwitchKeepsItsChoicesAndItsChosenPropertiesCount() {
    assertThat(
            lines(
                """
                DEF Version Switch {
                  whichChild 1
                  Cube {}
                  Separator { Sphere {} Cone {} }
                }
                """))
        .containsExactly(
            "Switch DEF=Version whichChoice=1",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box",
            " Group",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Cone");
    assertThat(
            lines(
                "Switch { whichChild 0 Material { diffuseColor 1 0 0 } Material { diffuseColor 0 1"
                    + " 0 } } Cube {}"))
        .containsExactly("Shape", " Appearance", "  Material diffuseColor=1 0 0", " Box");
    assertThat(lines("Switch { whichChild -3 Cube {} Sphere {} }")).contains("  Box", "  Sphere");
  }

  @Test
  void anObjectIsUsedAgainWhereItLooksTheSame() {
    assertThat(
            lines(
                """
                DEF Wheel Separator { Material { diffuseColor 1 0 0 } Cylinder {} }
                Separator { Translation { translation 2 0 0 } Material {} USE Wheel }
                """))
        .containsExactly(
            "Group DEF=Wheel",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=1 0 0",
            "  Cylinder",
            "Transform translation=2 0 0",
            " Group USE=Wheel");
  }

  @Test
  void anObjectIsCopiedWhereAnotherMaterialCounts() {
    assertThat(
            lines(
                """
                DEF Ball Sphere {}
                Material { diffuseColor 1 0 0 }
                USE Ball
                """))
        .containsExactly(
            "Shape DEF=Ball",
            " Appearance",
            "  Material",
            " Sphere",
            "Shape DEF=Ball_2",
            " Appearance",
            "  Material diffuseColor=1 0 0",
            " Sphere");
  }

  @Test
  void aCoordinateIsWrittenOnce() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                IndexedFaceSet { coordIndex [ 0 1 2 -1 ] }
                IndexedFaceSet { coordIndex [ 2 1 0 -1 ] }
                """))
        .contains(
            "  Coordinate DEF=Coordinate_1 point=0 0 0, 1 0 0, 1 1 0",
            "  Coordinate USE=Coordinate_1");
  }

  @Test
  void aNodeWithinItselfIsNoNode() {
    X3dFile file = scene(fixture, "DEF A Separator { Cube {} USE A }");
    assertThat(file.nodes()).hasSize(1);
    fixture.assertOnly(
        "test.x3d:2:27: no node before this one has the name 'A'; the USE is left out");
  }

  /** Returns the lines of the materials in which shapes of a type are drawn, or their names. */
  private static List<String> materials(String content) {
    return lines(content).stream()
        .map(String::strip)
        .filter(l -> l.startsWith("Material"))
        .toList();
  }

  @Test
  void aGroupThatIsUsedSetsItsMaterialAgainThoughItCountedBefore() {
    assertThat(
            materials(
                "DEF M Material { diffuseColor 1 0 0 } DEF G Group { USE M }"
                    + " Material { diffuseColor 0 0 1 } USE G Sphere {}"))
        .containsExactly("Material DEF=M diffuseColor=1 0 0");
  }

  @Test
  void aGroupThatIsUsedTwiceInARowSetsItsMaterialForWhoeverUsesBoth() {
    assertThat(
            materials(
                "DEF G Group { Material { diffuseColor 1 0 0 } } DEF H Group { USE G }"
                    + " Material { diffuseColor 0 0 1 } USE H Sphere {}"))
        .containsExactly("Material diffuseColor=1 0 0");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "DEF G Group { Separator { USE M } }",
        "DEF G Group { WWWAnchor { USE M } }",
        "DEF G Separator { USE M }",
        "DEF G Switch { whichChild 1 USE M Info {} }",
        "DEF G LOD { USE M Info {} }",
      })
  void aNodeThatRestoresTheStateSetsNothingWhereItIsUsed(String restores) {
    assertThat(
            materials(
                "DEF M Material { diffuseColor 1 0 0 } "
                    + restores
                    + " Material { diffuseColor 0 0 1 } USE G Sphere {}"))
        .containsExactly("Material diffuseColor=0 0 1");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "DEF G TransformSeparator { USE M }",
        "DEF G Switch { whichChild 0 USE M Info {} }",
        "DEF G Switch { whichChild -3 USE M }",
        "DEF G Group { Group { TransformSeparator { USE M } } }",
      })
  void aNodeThatKeepsTheMaterialSetsItWhereItIsUsed(String keeps) {
    assertThat(
            materials(
                "DEF M Material { diffuseColor 1 0 0 } "
                    + keeps
                    + " Material { diffuseColor 0 0 1 } USE G Sphere {}"))
        .containsExactly("Material DEF=M diffuseColor=1 0 0");
  }

  @Test
  void anObjectThatSetsItsOwnMaterialIsUsedAgainUnderAnother() {
    assertThat(
            lines(
                """
                DEF M Material { diffuseColor 1 0 0 }
                DEF Ball Separator { USE M Sphere {} }
                Material { diffuseColor 0 0 1 }
                USE Ball
                """))
        .endsWith("Group USE=Ball");
  }
}

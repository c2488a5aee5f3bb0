package org.selectiverenderer.x3d.catalogue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

class NodeCatalogueTest {
  private final NodeCatalogue catalogue = NodeCatalogue.load();

  @Test
  void knowsAllConcreteNodesOfTheStandard() {
    assertThat(catalogue.all()).hasSize(263).doesNotHaveDuplicates();
    assertThat(catalogue.all().stream().mapToInt(type -> type.fields().size()).sum())
        .isEqualTo(2673);
    assertThat(catalogue.all())
        .allSatisfy(type -> assertThat(catalogue.get(type.name())).isSameAs(type))
        .allSatisfy(type -> assertThat(type.fields()).isNotEmpty())
        .allSatisfy(type -> assertThat(type.ancestors()).isNotEmpty().doesNotContain(""));
  }

  @Test
  void knowsNodesAndFieldsOfTheDraftOf41AfterThoseOfTheStandard() {
    NodeType faces = catalogue.get("IndexedFaceSet");
    assertThat(faces.fields().get(faces.fields().size() - 1).name()).isEqualTo("tangent");
    assertThat(catalogue.get("Tangent").field("vector").orElseThrow().type())
        .isEqualTo(FieldType.MFVec4f);
    assertThat(List.copyOf(catalogue.names()))
        .containsSubsequence("Layout", "LayoutGroup", "Tangent", "Text")
        .isSortedAccordingTo(String.CASE_INSENSITIVE_ORDER);
  }

  @Test
  void everyDefaultIsAValueOfItsType() {
    FieldParser parser = new FieldParser();
    for (NodeType type : catalogue.all()) {
      for (FieldDefinition field : type.fields()) {
        String text = field.defaultText();
        if (field.type() == FieldType.SFNode) {
          assertThat(field.defaultValue()).isNull();
          assertThat(text).isIn("", "NULL");
        } else {
          assertThat(field.defaultValue())
              .as(type + "." + field)
              .hasSameClassAs(field.type() == FieldType.MFNode ? List.of() : field.type().zero());
        }
        if (!field.type().isNode() && !text.isEmpty()) {
          assertThat(parser.parse(field.type(), text).flaws()).as(type + "." + field).isEmpty();
        }
      }
    }
  }

  @Test
  void givesFieldsAsTheStandardDefinesThem() {
    NodeType transform = catalogue.get("Transform");
    assertThat(transform.component()).isEqualTo("Grouping");
    assertThat(transform.is("X3DGroupingNode")).isTrue();
    FieldDefinition rotation = transform.fields().get(transform.indexOf("rotation"));
    assertThat(rotation.type()).isEqualTo(FieldType.SFRotation);
    assertThat((float[]) rotation.defaultValue()).containsExactly(0, 0, 1, 0);
    FieldDefinition choice = catalogue.get("Switch").field("whichChoice").orElseThrow();
    assertThat(choice.defaultValue()).isEqualTo(-1);
    FieldDefinition geometry = catalogue.get("Shape").field("geometry").orElseThrow();
    assertThat(geometry.nodeTypes()).containsExactly("X3DGeometryNode");
    assertThat(catalogue.get("Box").containerField()).isEqualTo("geometry");
  }

  @Test
  void givesAllowedStringsOneByOne() {
    assertThat(catalogue.get("Fog").field("fogType").orElseThrow().values())
        .containsExactly("LINEAR", "EXPONENTIAL");
    assertThat(catalogue.get("NavigationInfo").field("type").orElseThrow().values())
        .startsWith("\"ANY\"", "\"WALK\"");
    assertThat(catalogue.get("FontStyle").field("justify").orElseThrow().values())
        .contains("\"MIDDLE\"", "\"MIDDLE\" \"END\"");
  }

  @Test
  void aFieldWithoutADefaultIsZero() {
    FieldDefinition value = catalogue.get("MetadataFloat").field("value").orElseThrow();
    assertThat((float[]) value.defaultValue()).isEmpty();
    FieldDefinition changed =
        catalogue.get("OrientationInterpolator").field("value_changed").orElseThrow();
    assertThat((float[]) changed.defaultValue()).containsExactly(0, 0, 1, 0);
  }

  @Test
  void proposesTheNodeThatWasMeant() {
    assertThat(catalogue.suggestion("shape")).contains("Shape");
    assertThat(catalogue.suggestion("IndexFaceSet")).contains("IndexedFaceSet");
    assertThat(catalogue.suggestion("Teapot")).isEmpty();
  }

  @Test
  void saysWhichNodeItDoesNotHave() {
    assertThat(catalogue.find("Teapot")).isEmpty();
    assertThatThrownBy(() -> catalogue.get("Teapot"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("Teapot");
  }
}

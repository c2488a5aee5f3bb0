package org.selectiverenderer.polygon.metadata;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;

class NodeViewMetadataTest {
  private final NodeCatalogue catalogue = NodeCatalogue.load();

  private ParsedNode node(String type) {
    return new ParsedNode(catalogue.get(type), null, SourceLocation.of("test.x3d"));
  }

  private ParsedNode metadata(String type, String name, Object value) {
    ParsedNode node = node(type);
    node.put(node.type().indexOf("name"), name);
    node.put(node.type().indexOf("value"), value);
    return node;
  }

  @Test
  void readsSetsStringsAndNumbersOfAFile() {
    ParsedNode choice =
        metadata(
            "MetadataSet",
            "",
            List.of(
                metadata("MetadataFloat", "degreeOfConsistency", new float[] {0.25f}),
                metadata("MetadataString", "schemaBelonginess", new String[] {"A", "B"})));
    ParsedNode object = node("Switch");
    object.put(object.type().indexOf("metadata"), choice);
    List<SchemaProblem> problems = new ArrayList<>();

    NodeViewMetadata source = NodeViewMetadata.of(object).orElseThrow();
    SwitchSchemas schemas = new SchemaReader(problems::add).switchNode(source, 1).orElseThrow();

    assertThat(source.isSet()).isTrue();
    assertThat(schemas.choices().get(0).degree()).contains(new ConsistencyDegree(0.25));
    assertThat(schemas.choiceBySchema()).containsOnlyKeys("A", "B");
    assertThat(problems).isEmpty();
  }

  @Test
  void aNodeWithoutMetadataHasNone() {
    assertThat(NodeViewMetadata.of(node("Switch"))).isEmpty();
  }
}

package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch.ChoiceNode;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Reads the schema metadata of single Switches and ProximitySensors of a document. */
final class EnrichedNodeReader {
  private final SceneDocument document;
  private final NodeCatalogue catalogue;

  EnrichedNodeReader(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
  }

  /**
   * @param index among all Switches, from 0
   */
  EnrichedSwitch switchNode(DocumentElement element, int index) {
    List<ElementFinding> findings = new ArrayList<>();
    List<DocumentElement> children = element.children().stream().filter(this::isChoice).toList();
    Optional<MetadataElement> metadata = MetadataElement.of(document, element);
    SchemaReader reader = new SchemaReader(problem -> findings.add(finding(problem)));
    Optional<SwitchSchemas> schemas =
        metadata.flatMap(source -> reader.switchNode(source, children.size()));
    List<FieldQuality> qualities = metadata.map(reader::fieldQualities).orElse(List.of());
    List<VersionMetadata> described = schemas.map(SwitchSchemas::choices).orElse(List.of());
    List<ChoiceNode> choices = new ArrayList<>();
    for (int i = 0; i < children.size(); i++) {
      DocumentElement child = children.get(i);
      ChoiceMetadata values =
          i < described.size() ? ChoiceMetadata.of(described.get(i)) : ChoiceMetadata.NONE;
      choices.add(new ChoiceNode(i, child, url(child), values));
    }
    return new EnrichedSwitch(
        element,
        element.def().orElse("Switch#" + (index + 1)),
        MetadataNames.object(element.def().orElse("Switch" + (index + 1))),
        choices,
        whichChoice(element),
        schemas,
        metadata.map(EnrichedFieldReader::read).orElse(List.of()),
        qualities,
        findings);
  }

  /** Returns whether a child has an index, as the scene reader counts choices. */
  private boolean isChoice(DocumentElement element) {
    return element.name().equals("ProtoInstance")
        || catalogue.find(element.name()).filter(type -> type.is("X3DChildNode")).isPresent();
  }

  private String url(DocumentElement child) {
    if (!child.name().equals("Inline")) {
      return "";
    }
    DocumentElement named =
        child
            .use()
            .flatMap(use -> document.tree().flatMap(tree -> tree.named(use, child)))
            .orElse(child);
    List<String> urls = MFStringParser.strings(document.attribute(named, "url").orElse(""));
    return urls.isEmpty() ? "" : urls.get(0);
  }

  private int whichChoice(DocumentElement element) {
    String text = document.attribute(element, "whichChoice").orElse("-1").strip();
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      return -1; // the scene reader reports it, and shows nothing
    }
  }

  /**
   * @param index among all ProximitySensors, from 0
   */
  EnrichedSensor sensorNode(DocumentElement element, int index) {
    List<ElementFinding> findings = new ArrayList<>();
    SchemaReader reader = new SchemaReader(problem -> findings.add(finding(problem)));
    Optional<SensorSchemas> schemas = MetadataElement.of(document, element).flatMap(reader::sensor);
    return new EnrichedSensor(
        element,
        element.def().orElse("ProximitySensor#" + (index + 1)),
        schemas.orElse(new SensorSchemas(List.of(), List.of())),
        schemas.isPresent(),
        findings);
  }

  private static ElementFinding finding(SchemaProblem problem) {
    return new ElementFinding(
        ((MetadataElement) problem.metadata()).meant(),
        Problem.Severity.WARNING,
        problem.message(),
        Optional.empty());
  }

  /** Returns whether some metadata of a node is in another node, by USE. */
  boolean shares(DocumentElement element) {
    for (DocumentElement child : element.children()) {
      boolean metadata = child.name().startsWith("Metadata");
      boolean elsewhere =
          child.use().isPresent() && (metadata || child.name().equals("Inline")); // its url
      if (elsewhere || metadata && shares(child)) {
        return true;
      }
    }
    return false;
  }
}

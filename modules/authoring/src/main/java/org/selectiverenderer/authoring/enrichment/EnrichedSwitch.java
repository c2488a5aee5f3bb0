package org.selectiverenderer.authoring.enrichment;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A Switch of a document with its schema metadata: an object with versions.
 *
 * @param name its DEF, or {@code Switch#3} for the third Switch if it has none
 * @param object the object's own name, without {@code Switch_}
 * @param choices its children in order
 * @param whichChoice index of the initially shown choice; -1 for none
 * @param schemas its schema metadata; empty where it has none
 * @param fields its further qualities, which are values of fields, as they are written
 * @param qualities the same with the schemas that activate their levels
 * @param findings the findings about its metadata
 */
public record EnrichedSwitch(
    DocumentElement element,
    String name,
    String object,
    List<ChoiceNode> choices,
    int whichChoice,
    Optional<SwitchSchemas> schemas,
    List<EnrichedField> fields,
    List<FieldQuality> qualities,
    List<ElementFinding> findings) {
  public EnrichedSwitch {
    choices = List.copyOf(choices);
    fields = List.copyOf(fields);
    qualities = List.copyOf(qualities);
    findings = List.copyOf(findings);
  }

  /**
   * A child of the Switch: a version of the object.
   *
   * @param index from 0
   * @param url first URL of an Inline; empty for other nodes
   */
  public record ChoiceNode(int index, DocumentElement element, String url, ChoiceMetadata values) {}

  /** Returns whether it has schema metadata. */
  public boolean enriched() {
    return schemas.isPresent();
  }

  /** Returns whether schemas choose its versions, or levels of its other qualities. */
  public boolean controlled() {
    return enriched() || !qualities.isEmpty();
  }

  /** Returns what its versions differ in: polygons, unless the metadata name another quality. */
  public Quality quality() {
    return schemas.map(SwitchSchemas::quality).orElse(Quality.POLYGONS);
  }

  /** Returns the metadata of all choices in order. */
  public List<ChoiceMetadata> values() {
    return choices.stream().map(ChoiceNode::values).toList();
  }
}

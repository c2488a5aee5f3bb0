package org.selectiverenderer.authoring.enrichment;

import java.util.List;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A quality of an object as it is written: a field, and the values from which schemas choose. It
 * differs from {@link org.selectiverenderer.schema.FieldQuality} in that levels without schemas
 * have none, although they follow the versions of the object.
 *
 * @param element the MetadataSet of the quality, or the USE of one
 * @param quality what the levels differ in
 * @param target the field that is set
 * @param levels the values, in the order of the text
 */
public record EnrichedField(
    DocumentElement element, Quality quality, FieldReference target, List<Level> levels) {
  /** Makes a defensive copy of the list. */
  public EnrichedField {
    levels = List.copyOf(levels);
  }

  /**
   * A value that the field may have.
   *
   * @param element the MetadataSet of the level, or the USE of one
   * @param metadata consistency and schemas
   * @param values the strings of its MetadataString {@code value}
   */
  public record Level(DocumentElement element, ChoiceMetadata metadata, List<String> values) {
    /** Makes a defensive copy of the list. */
    public Level {
      values = List.copyOf(values);
    }
  }
}

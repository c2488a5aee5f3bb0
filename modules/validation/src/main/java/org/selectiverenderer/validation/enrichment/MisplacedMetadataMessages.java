package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SchemaField.Owner;

/** Words why metadata in the wrong place have no effect. */
final class MisplacedMetadataMessages {
  static final String IN_AREA = "it describes a version of an object, not an area";

  private static final String IN_OBJECT = "it describes an area, not an object";
  private static final String BESIDE = "it is beside the sets of the choices, not inside one";

  private MisplacedMetadataMessages() {}

  static String inSwitch(NodeViewMetadata metadata) {
    boolean ofArea =
        SchemaField.of(metadata.name()).filter(f -> f.owner() == Owner.SENSOR).isPresent();
    return ofArea ? IN_OBJECT : BESIDE;
  }
}

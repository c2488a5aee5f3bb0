package org.selectiverenderer.browser.sai;

import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DFieldTypes;

/**
 * The SAI's field definition of a field of the node catalogue.
 *
 * @param typeNumber the field type's constant of {@link X3DFieldTypes}
 */
record EmbeddedFieldDefinition(FieldDefinition field, int typeNumber)
    implements X3DFieldDefinition {
  @Override
  public String getName() {
    return field.name();
  }

  @Override
  public int getAccessType() {
    return switch (field.access()) {
      case INITIALIZE_ONLY -> X3DFieldTypes.INITIALIZE_ONLY;
      case INPUT_ONLY -> X3DFieldTypes.INPUT_ONLY;
      case OUTPUT_ONLY -> X3DFieldTypes.OUTPUT_ONLY;
      case INPUT_OUTPUT -> X3DFieldTypes.INPUT_OUTPUT;
    };
  }

  @Override
  public int getFieldType() {
    return typeNumber;
  }

  @Override
  public String getFieldTypeString() {
    return field.type().name();
  }
}

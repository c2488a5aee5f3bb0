package org.selectiverenderer.browser.nodes.shader;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A ComposedShader, ProgramShader, PackagedShader or ShaderProgram (X3D 4.0, 31.4). The values that
 * the author's fields receive are stored, also those of inputOnly fields: the last value is that of
 * the uniform.
 */
public final class ShaderNode extends Node {
  private final int activate;
  private final int isValid;
  private final int isSelected;
  private @Nullable Boolean valid;
  private @Nullable Boolean selected;
  private @Nullable Boolean toldValid;
  private @Nullable Boolean toldSelected;

  public ShaderNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    activate = index(type, "activate");
    isValid = index(type, "isValid");
    isSelected = index(type, "isSelected");
  }

  private static int index(NodeType type, String field) {
    return type.field(field).map(FieldDefinition::index).orElse(-1);
  }

  /**
   * Returns whether a change of a field requires no rebuild: values of uniforms are read whenever
   * the shape is drawn, and isValid and isSelected are only outputs.
   */
  public boolean onlyNumbers(int field) {
    return field == isValid
        || field == isSelected
        || (own(field) && !type().fields().get(field).type().isNode());
  }

  /** Returns whether the field is one that the author declared. */
  private boolean own(int field) {
    return field >= type().ownFrom();
  }

  /**
   * Stores the result of compiling the program, which {@link #tell} sends.
   *
   * @param compiled whether the program compiled and linked
   * @param chosen whether shapes are drawn with the program
   */
  public void judged(boolean compiled, boolean chosen) {
    valid = compiled;
    selected = chosen;
  }

  /** Sends isSelected and isValid if they have changed. */
  public void tell(EventCascade cascade) {
    if (selected != null && !selected.equals(toldSelected) && isSelected >= 0) {
      toldSelected = selected;
      emit(isSelected, selected, cascade);
    }
    if (valid != null && !valid.equals(toldValid) && isValid >= 0) {
      toldValid = valid;
      emit(isValid, valid, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() == activate) {
      // Changes take effect at once, so that activate only sends the state again.
      if (Boolean.TRUE.equals(value)) {
        toldValid = null;
        toldSelected = null;
        tell(cascade);
      }
    } else if (field.access() == AccessType.INPUT_ONLY && own(field.index()) && value != null) {
      derive(field.index(), value);
    } else {
      super.receive(field, value, cascade);
    }
  }
}

package org.selectiverenderer.runtime.nodes.shader;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A ComposedShader, ProgramShader or PackagedShader, or a ShaderProgram (X3D 4.0, 31.4). What its
 * author's fields receive is kept, those that only receive included: their last value is the
 * program's.
 */
public final class ShaderNode extends Node {
  private final int activate;
  private final int isValid;
  private final int isSelected;
  private @Nullable Boolean valid;
  private @Nullable Boolean selected;
  private @Nullable Boolean toldValid;
  private @Nullable Boolean toldSelected;

  public ShaderNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    activate = index(type, "activate");
    isValid = index(type, "isValid");
    isSelected = index(type, "isSelected");
  }

  private static int index(NodeType type, String field) {
    return type.field(field).map(FieldDefinition::index).orElse(-1);
  }

  /**
   * Whether what is drawn need not be made anew when a field changes: its numbers are asked for
   * whenever it is drawn, and isValid and isSelected only tell.
   */
  public boolean onlyNumbers(int field) {
    return field == isValid
        || field == isSelected
        || (own(field) && !type().fields().get(field).type().isNode());
  }

  /** Whether the field is one that the author declared. */
  private boolean own(int field) {
    return field >= type().ownFrom();
  }

  /**
   * What has come of its program, for {@link #tell} to send.
   *
   * @param compiled whether the graphics card takes it
   * @param chosen whether shapes are drawn with it
   */
  public void judged(boolean compiled, boolean chosen) {
    valid = compiled;
    selected = chosen;
  }

  /** Sends isSelected and isValid where they have changed. */
  public void tell(Cascade cascade) {
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
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.index() == activate) {
      // Changes count at once, so that there is nothing to do but to say again what is so.
      if (Boolean.TRUE.equals(value)) {
        toldValid = null;
        toldSelected = null;
        tell(cascade);
      }
    } else if (field.access() == FieldAccess.INPUT_ONLY && own(field.index()) && value != null) {
      derive(field.index(), value);
    } else {
      super.receive(field, value, cascade);
    }
  }
}

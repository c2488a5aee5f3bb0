package org.selectiverenderer.browser.nodes.shape;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * GeneratedCubeMapTexture (X3D 4.0, 34.4.2): tells when its cube map is to be drawn; the renderer
 * remembers which requests it has served. After {@code NEXT_FRAME_ONLY} the node sends {@code
 * update} NONE in the following frame, whether or not anything was drawn.
 */
public final class GeneratedCubeMapTextureNode extends Node implements FrameDrivenNode {
  private final int update;
  private boolean asked;
  private long request;

  public GeneratedCubeMapTextureNode(
      NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    update = type.indexOf("update");
  }

  /**
   * Returns the index of the field {@code update}, whose changes affect nothing but the cube map.
   */
  public int updateField() {
    return update;
  }

  /** Returns whether the cube map is drawn in every frame. */
  public boolean always() {
    return "ALWAYS".equals(value(update));
  }

  /** Returns how often the cube map has been requested with {@code NEXT_FRAME_ONLY}. */
  public long request() {
    return request;
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() == update) {
      asked = false;
    }
    super.receive(field, value, cascade);
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    if (!"NEXT_FRAME_ONLY".equals(value(update))) {
      return;
    }
    if (asked) {
      asked = false;
      emit(update, "NONE", cascade);
    } else {
      asked = true;
      request++;
    }
  }
}

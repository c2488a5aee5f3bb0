package org.selectiverenderer.control;

import java.util.List;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.SFNode;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DNode;

/** The child nodes in an SFNode or MFNode field. */
final class FieldBranch extends Branch {
  private final SceneScope scope;
  private final X3DField field;
  private final X3DFieldEventListener onChange;

  FieldBranch(SceneScope scope, X3DField field, Turn turn, Listener listener) {
    super(listener);
    this.scope = scope;
    this.field = field;
    this.onChange = event -> turn.take(() -> changed(event.getTime()));
  }

  @Override
  SceneScope scope() {
    return scope;
  }

  @Override
  List<X3DNode> look() {
    if (field instanceof MFNode nodes) {
      X3DNode[] array = new X3DNode[nodes.getSize()];
      nodes.getValue(array);
      return scope.opened(array);
    }
    return scope.opened(new X3DNode[] {((SFNode) field).getValue()});
  }

  @Override
  void listen() {
    if (field.getDefinition().getAccessType() != X3DFieldTypes.INITIALIZE_ONLY) {
      field.addX3DEventListener(onChange);
    }
  }

  @Override
  void close() {
    FieldRelease.remove(field, onChange);
  }
}

package org.selectiverenderer.validation.language;

import java.util.Optional;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Checks IS statements: fields of nodes in a prototype's body, connected with fields of its
 * interface.
 */
final class PrototypeConnectCheck implements NameScopeCheck {
  @Override
  public void check(DocumentElement element, NameScopes scopes, FindingCollector findings) {
    if (!element.name().equals("IS")) {
      return;
    }
    PrototypeDeclaration prototype = around(element).orElse(null);
    DocumentElement node = element.parent().orElse(null);
    if (prototype == null || node == null) {
      findings.add(
          PrototypeRules.CONNECT, element, "IS is allowed only in the body of a prototype");
      return;
    }
    for (DocumentElement connect : element.children()) {
      connect(connect, node, prototype, scopes, findings);
    }
  }

  private static Optional<PrototypeDeclaration> around(DocumentElement element) {
    for (Optional<DocumentElement> at = element.parent(); at.isPresent(); at = at.get().parent()) {
      if (at.get().name().equals("ProtoDeclare")) {
        return at.map(PrototypeDeclaration::new);
      }
    }
    return Optional.empty();
  }

  private static void connect(
      DocumentElement connect,
      DocumentElement node,
      PrototypeDeclaration prototype,
      NameScopes scopes,
      FindingCollector findings) {
    String nodeField = connect.text("nodeField").orElse("").strip();
    String protoField = connect.text("protoField").orElse("").strip();
    if (nodeField.isEmpty() || protoField.isEmpty()) {
      findings.add(PrototypeRules.CONNECT, connect, "connect needs nodeField and protoField");
      return;
    }
    NodeInterface outer = prototype.fields();
    NodeInterface inner = scopes.fields(node).orElse(null);
    NodeInterface.Field declared = outer.own().get(protoField);
    if (declared == null) {
      SpellingSuggestion suggestion = SpellingSuggestion.of(protoField, outer.names());
      findings.add(
          PrototypeRules.CONNECT,
          connect,
          "the prototype " + prototype.name() + " has no field " + protoField + suggestion);
      return;
    }
    if (inner == null) {
      return;
    }
    // IS may name an event of an inputOutput field: set_x, x_changed.
    NodeInterface.Field field =
        inner
            .field(nodeField)
            .or(() -> inner.event(nodeField, true))
            .or(() -> inner.event(nodeField, false))
            .orElse(null);
    if (field == null) {
      SpellingSuggestion suggestion = SpellingSuggestion.of(nodeField, inner.names());
      findings.add(
          PrototypeRules.CONNECT,
          connect,
          inner.owner() + " has no field " + nodeField + suggestion);
    } else if (field.type() != declared.type()) {
      findings.add(
          PrototypeRules.CONNECT,
          connect,
          nodeField + " is " + field.type() + " and " + protoField + " is " + declared.type());
    } else if (!allowed(field.access(), declared.access())) {
      findings.add(
          PrototypeRules.CONNECT,
          connect,
          "an %s field of a prototype cannot stand for an %s field of a node (%s)"
              .formatted(declared.access().spelling(), field.access().spelling(), nodeField));
    }
  }

  /**
   * Returns whether X3D 4.0, table 4.4, allows the connection: an inputOutput field of a node may
   * be connected with a field of any access in the interface.
   */
  private static boolean allowed(AccessType node, AccessType prototype) {
    return node == AccessType.INPUT_OUTPUT || node == prototype;
  }
}

package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks declarations and instances of prototypes. */
final class PrototypeCheck implements NameScopeCheck {
  @Override
  public void check(DocumentElement element, NameScopes scopes, FindingCollector findings) {
    switch (element.name()) {
      case "ProtoDeclare" -> declaration(element, scopes, findings);
      case "ExternProtoDeclare" -> external(element, scopes, findings);
      case "ProtoInstance" -> instance(element, scopes, findings);
      case "field" -> field(element, findings);
      default -> {
        // Other checks handle other elements.
      }
    }
  }

  private static void declaration(
      DocumentElement element, NameScopes scopes, FindingCollector findings) {
    if (element.text("name").orElse("").isBlank()) {
      findings.add(PrototypeRules.DECLARATION, element, "a name");
    }
    if (element.children().stream().noneMatch(child -> child.name().equals("ProtoBody"))) {
      if (!scopes.file().document().broken()) {
        findings.add(PrototypeRules.DECLARATION, element, "a ProtoBody");
      }
    }
  }

  /** Reports the faults that the reader found in an external declaration and its fields. */
  private static void external(
      DocumentElement element, NameScopes scopes, FindingCollector findings) {
    for (Problem fault : scopes.file().scene().externFaults()) {
      boolean ofField = element.children().stream().anyMatch(field -> at(fault, field));
      if (ofField || at(fault, element)) {
        findings.addWithin(PrototypeRules.EXTERNAL, element, fault.location(), fault.message());
      }
    }
  }

  private static boolean at(Problem fault, DocumentElement element) {
    return fault.location().equals(element.location());
  }

  private static void instance(
      DocumentElement element, NameScopes scopes, FindingCollector findings) {
    if (element.attribute("USE").isPresent()) {
      return;
    }
    DocumentAttribute name = element.attribute("name").orElse(null);
    if (name == null) {
      findings.add(PrototypeRules.UNKNOWN, element, "''", "");
      return;
    }
    PrototypeDeclaration prototype = scopes.prototype(name.text().strip(), element).orElse(null);
    if (prototype == null) {
      SpellingSuggestion suggestion =
          SpellingSuggestion.of(name.text(), scopes.prototypes(element));
      findings.add(PrototypeRules.UNKNOWN, name, name.text(), suggestion);
      return;
    }
    for (Optional<DocumentElement> at = element.parent(); at.isPresent(); at = at.get().parent()) {
      if (at.get() == prototype.element()) {
        findings.add(PrototypeRules.ITSELF, element, name.text());
        return;
      }
    }
    values(element, prototype, findings);
  }

  private static void values(
      DocumentElement instance, PrototypeDeclaration prototype, FindingCollector findings) {
    NodeInterface fields = prototype.fields();
    boolean unknown = prototype.external() && fields.own().isEmpty();
    for (DocumentElement child : instance.children()) {
      if (!child.name().equals("fieldValue") || unknown) {
        continue;
      }
      String name = child.text("name").orElse("").strip();
      NodeInterface.Field field = fields.own().get(name);
      if (field == null) {
        SpellingSuggestion suggestion = SpellingSuggestion.of(name, fields.names());
        findings.add(PrototypeRules.UNKNOWN_FIELD, child, prototype.name(), name, suggestion);
      } else {
        value(child, field.type(), findings);
      }
    }
  }

  private static void field(DocumentElement element, FindingCollector findings) {
    String name = element.text("name").orElse("").strip();
    String type = element.text("type").orElse("");
    String access = element.text("accessType").orElse("");
    for (String needed : List.of("name", "type", "accessType")) {
      if (element.attribute(needed).isEmpty() && !StatementAttributes.lacks(element, needed)) {
        return;
      }
    }
    if (name.isEmpty()) {
      findings.add(PrototypeRules.FIELD, element, "a field needs a name");
    } else if (NodeInterface.type(type).isEmpty()) {
      SpellingSuggestion suggestion =
          SpellingSuggestion.of(
              type, List.of(FieldType.values()).stream().map(Enum::name).toList());
      String fault =
          type.isBlank()
              ? "a field needs a type"
              : "'" + type + "' is not a type of field" + suggestion;
      report(element, "type", fault, findings);
    } else if (NodeInterface.access(access).isEmpty()) {
      report(element, "accessType", accessFault(access.strip()), findings);
    } else {
      value(element, NodeInterface.type(type).orElseThrow(), findings);
    }
  }

  /** Reports a fault at an attribute, or at the element if the attribute is missing. */
  private static void report(
      DocumentElement element, String attribute, String fault, FindingCollector findings) {
    DocumentAttribute at = element.attribute(attribute).orElse(null);
    if (at == null) {
      findings.add(PrototypeRules.FIELD, element, fault);
    } else {
      findings.add(PrototypeRules.FIELD, at, fault);
    }
  }

  private static String accessFault(String access) {
    if (access.isEmpty()) {
      return "a field needs an accessType";
    }
    // The words of VRML 97, which differ too much from those of X3D for a spelling suggestion.
    String now =
        switch (access) {
          case "field" -> "initializeOnly";
          case "exposedField" -> "inputOutput";
          case "eventIn" -> "inputOnly";
          case "eventOut" -> "outputOnly";
          default -> "";
        };
    Object hint =
        now.isEmpty()
            ? SpellingSuggestion.of(
                access, Stream.of(AccessType.values()).map(AccessType::spelling).toList())
            : ", but VRML's word for " + now;
    return "'" + access + "' is not an accessType" + hint;
  }

  private static void value(DocumentElement element, FieldType type, FindingCollector findings) {
    DocumentAttribute value = element.attribute("value").orElse(null);
    if (value != null && type.isNode()) {
      if (!value.text().isBlank() && !value.text().strip().equals("NULL")) {
        findings.add(
            PrototypeRules.FIELD, element, "nodes are given as child elements, not as a value");
      }
    } else if (value != null) {
      FieldCheck.value(value, type, findings);
    }
  }
}

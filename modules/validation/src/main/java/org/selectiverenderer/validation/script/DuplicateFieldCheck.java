package org.selectiverenderer.validation.script;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds fields of a Script or a shader that are declared twice. */
final class DuplicateFieldCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      file.catalogue()
          .find(element.name())
          .filter(type -> type.field("field").isPresent())
          .ifPresent(type -> fields(element, type, findings));
    }
  }

  /** Returns the names that ClassicVRML declares again for each IS. */
  private static Set<String> connectedTwice(DocumentElement element) {
    Set<String> once = new HashSet<>();
    Set<String> twice = new HashSet<>();
    for (DocumentElement child : element.children()) {
      if (child.name().equals("IS")) {
        child.children().stream()
            .flatMap(connect -> connect.text("nodeField").stream())
            .filter(name -> !once.add(name))
            .forEach(twice::add);
      }
    }
    return twice;
  }

  private static void fields(DocumentElement element, NodeType type, FindingCollector findings) {
    Set<String> names = new HashSet<>(ParsedNode.TAKEN_NAMES);
    Set<String> connected = connectedTwice(element);
    for (DocumentElement child : element.children()) {
      if (child.name().equals("field")) {
        child
            .attribute("name")
            .filter(name -> !names.add(name.text()) && !connected.contains(name.text()))
            .ifPresent(name -> findings.add(ScriptRules.TWICE, name, type.name(), name.text()));
      }
    }
  }
}

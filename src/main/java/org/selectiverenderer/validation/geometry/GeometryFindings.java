package org.selectiverenderer.validation.geometry;

import java.util.Optional;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.x3d.DocumentAttribute;
import org.selectiverenderer.x3d.ParsedNode;

/** Puts findings about fields at the attributes that give them. */
record GeometryFindings(FileView file, Findings findings) {
  void add(Rule rule, ParsedNode node, Object... words) {
    findings.add(rule, node, words);
  }

  /** At the attribute of that field, or at the node where the value comes from elsewhere. */
  void addAt(Rule rule, ParsedNode node, String field, Object... words) {
    Optional<DocumentAttribute> attribute =
        file.document().elements().stream()
            .filter(element -> element.location().equals(node.location()))
            .findFirst()
            .flatMap(element -> element.attribute(field));
    if (attribute.isPresent()) {
      findings.add(rule, attribute.get(), words);
    } else {
      findings.add(rule, node, words);
    }
  }
}

package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks DEF, USE, IMPORT and EXPORT. */
final class DefUseCheck implements NameScopeCheck {
  private static final Set<String> WITH_USE =
      Set.of("USE", "DEF", "containerField", "class", "id", "style", "");

  @Override
  public void check(DocumentElement element, NameScopes scopes, FindingCollector findings) {
    if (element.name().equals("EXPORT") || element.name().equals("IMPORT")) {
      link(element, scopes, findings);
    }
    if (!scopes.isNode(element)) {
      return;
    }
    element.attribute("DEF").ifPresent(def -> define(def, scopes, findings));
    element.attribute("USE").ifPresent(use -> use(use, scopes, findings));
  }

  private static void define(DocumentAttribute def, NameScopes scopes, FindingCollector findings) {
    String name = def.text();
    String why = fault(name);
    if (!why.isEmpty()) {
      findings.add(DefUseRules.BAD_NAME, def, name, why);
    }
    List<DocumentElement> all = scopes.of(def.element()).names.getOrDefault(name, List.of());
    if (all.size() > 1 && all.get(0) != def.element()) {
      findings.add(DefUseRules.TWICE, def, name, all.get(0).name());
    }
  }

  /** Returns why a name is invalid; empty for a valid one. */
  private static String fault(String name) {
    if (name.isEmpty()) {
      return "it is empty";
    }
    if (Character.isDigit(name.charAt(0)) || "+-.".indexOf(name.charAt(0)) >= 0) {
      return "it begins with '" + name.charAt(0) + "'";
    }
    Optional<String> bad =
        name.codePoints()
            .filter(c -> c <= ' ' || c == 127 || "\"#',[\\]{}".indexOf(c) >= 0)
            .mapToObj(c -> c <= ' ' ? "white space" : "'" + Character.toString(c) + "'")
            .findFirst();
    return bad.map(character -> "it has " + character).orElse("");
  }

  private static void use(DocumentAttribute use, NameScopes scopes, FindingCollector findings) {
    DocumentElement element = use.element();
    String name = use.text();
    DocumentElement named = scopes.before(name, element).orElse(null);
    if (named == null) {
      if (!scopes.of(element).imported.contains(name)) {
        Set<String> names = scopes.of(element).names.keySet();
        Object hint =
            names.contains(name)
                ? "; the name is given further down"
                : SpellingSuggestion.of(name, names);
        findings.add(DefUseRules.UNKNOWN, use, name, hint);
      }
    } else if (holds(named, element)) {
      findings.add(DefUseRules.CIRCLE, use, name);
    } else if (!named.name().equals(element.name())) {
      findings.add(DefUseRules.OTHER_TYPE, use, name, named.name(), element.name());
    }
    more(element, findings);
  }

  private static void more(DocumentElement element, FindingCollector findings) {
    if (element.attribute("DEF").isPresent()) {
      findings.add(DefUseRules.MORE_THAN_USE, element, "a DEF too", "gives no second name");
    }
    String others =
        element.attributes().stream()
            .map(DocumentAttribute::name)
            .filter(name -> !WITH_USE.contains(name))
            .filter(name -> !(name.equals("name") && element.name().equals("ProtoInstance")))
            .collect(Collectors.joining(", "));
    if (!others.isEmpty()) {
      findings.add(DefUseRules.MORE_THAN_USE, element, others, "has no effect");
    } else if (!element.children().isEmpty()) {
      findings.add(DefUseRules.MORE_THAN_USE, element, "child elements", "have no effect");
    }
  }

  private static boolean holds(DocumentElement outer, DocumentElement inner) {
    for (Optional<DocumentElement> at = inner.parent(); at.isPresent(); at = at.get().parent()) {
      String name = at.get().name();
      if (name.equals("Script") || name.equals("fieldValue")) {
        return false; // A Script, or a prototype instance, may refer to its ancestors.
      }
      if (at.get() == outer) {
        return true;
      }
    }
    return false;
  }

  private static void link(DocumentElement element, NameScopes scopes, FindingCollector findings) {
    boolean export = element.name().equals("EXPORT");
    for (String needed : export ? List.of("localDEF") : List.of("inlineDEF", "importedDEF")) {
      if (element.attribute(needed).isEmpty()) {
        if (StatementAttributes.lacks(element, needed)) {
          findings.add(DefUseRules.LINK, element, element.name() + " needs " + needed);
        }
        return;
      }
    }
    DocumentAttribute named = element.attribute(export ? "localDEF" : "inlineDEF").orElseThrow();
    NameScopes.Scope scope = scopes.of(element);
    DocumentElement found = scopes.named(named.text(), element).orElse(null);
    if (found == null && !scope.imported.contains(named.text())) {
      findings.add(
          DefUseRules.LINK,
          named,
          "no node has the name "
              + named.text()
              + SpellingSuggestion.of(named.text(), scope.names.keySet()));
    } else if (!export && found != null && !found.name().equals("Inline")) {
      findings.add(
          DefUseRules.LINK, named, named.text() + " is a " + found.name() + ", not an Inline");
    }
  }
}

package org.selectiverenderer.validation.language;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks the endpoints of routes, their access and their types. One instance serves one file. */
final class RouteCheck implements NameScopeCheck {
  private static final List<String> NEEDED = List.of("fromNode", "fromField", "toNode", "toField");

  /** The scope and endpoints of a ROUTE; scopes are compared by identity. */
  private record Connection(NameScopes.Scope scope, List<String> ends) {}

  private final Set<Connection> seen = new HashSet<>();

  @Override
  public void check(DocumentElement element, NameScopes scopes, FindingCollector findings) {
    if (!element.name().equals("ROUTE")) {
      return;
    }
    for (String attribute : NEEDED) {
      if (element.text(attribute).orElse("").isBlank()) {
        if (element.attribute(attribute).isPresent()
            || StatementAttributes.lacks(element, attribute)) {
          findings.add(RouteRules.INCOMPLETE, element, attribute);
        }
        return;
      }
    }
    NodeInterface.Field from = end(element, "from", false, scopes, findings);
    NodeInterface.Field to = end(element, "to", true, scopes, findings);
    if (from != null && to != null && from.type() != to.type()) {
      findings.add(
          RouteRules.TYPES,
          element,
          text(element, "from"),
          from.type(),
          text(element, "to"),
          to.type());
    }
    repeated(element, scopes, findings);
  }

  /** Returns the field at an end; null if it does not exist or cannot be determined. */
  private static NodeInterface.@Nullable Field end(
      DocumentElement route,
      String end,
      boolean input,
      NameScopes scopes,
      FindingCollector findings) {
    DocumentAttribute node = route.attribute(end + "Node").orElseThrow();
    DocumentAttribute field = route.attribute(end + "Field").orElseThrow();
    DocumentElement named = scopes.named(node.text(), route).orElse(null);
    if (named == null) {
      NameScopes.Scope scope = scopes.of(route);
      if (!scope.imported.contains(node.text())) {
        SpellingSuggestion suggestion = SpellingSuggestion.of(node.text(), scope.names.keySet());
        findings.add(RouteRules.UNKNOWN_NODE, node, node.text(), suggestion);
      }
      return null;
    }
    NodeInterface fields = scopes.fields(named).orElse(null);
    if (fields == null) {
      return null;
    }
    Optional<NodeInterface.Field> found = fields.event(field.text(), input);
    if (found.isEmpty()) {
      SpellingSuggestion suggestion = SpellingSuggestion.of(field.text(), fields.names());
      findings.add(RouteRules.UNKNOWN_FIELD, field, fields.owner(), field.text(), suggestion);
      return null;
    }
    boolean fits =
        input ? found.get().access().acceptsEvents() : found.get().access().sendsEvents();
    if (!fits) {
      findings.add(
          RouteRules.DIRECTION,
          field,
          text(route, end),
          found.get().access().spelling(),
          input ? "does not receive events" : "does not send events");
      return null;
    }
    return found.get();
  }

  private static String text(DocumentElement route, String end) {
    return route.text(end + "Node").orElse("") + "." + route.text(end + "Field").orElse("");
  }

  private void repeated(DocumentElement route, NameScopes scopes, FindingCollector findings) {
    Connection connection =
        new Connection(
            scopes.of(route), NEEDED.stream().map(name -> route.text(name).orElse("")).toList());
    if (!seen.add(connection)) {
      findings.add(RouteRules.REPEATED, route);
    }
  }
}

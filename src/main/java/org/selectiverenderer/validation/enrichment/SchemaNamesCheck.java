package org.selectiverenderer.validation.enrichment;

import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.schema.SchemaNames;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.ParsedNode;

/**
 * Schemas that areas and objects do not share, as the controller mentions them when it starts: one
 * that says of all its objects what they show from the start needs no area, and exit schemas are
 * often activated for the sake of order alone.
 */
final class SchemaNamesCheck implements EnrichmentPart {
  @Override
  public void check(EnrichedScene scene, Findings findings) {
    Map<String, ParsedNode> entered = new LinkedHashMap<>();
    Map<String, ParsedNode> activated = new LinkedHashMap<>();
    scene
        .areas()
        .forEach(
            (sensor, schemas) -> {
              schemas.enter().forEach(schema -> entered.putIfAbsent(schema, sensor));
              schemas.enter().forEach(schema -> activated.putIfAbsent(schema, sensor));
              schemas.exit().forEach(schema -> activated.putIfAbsent(schema, sensor));
            });
    Map<String, ParsedNode> known = new LinkedHashMap<>();
    scene
        .objects()
        .forEach(
            (object, schemas) ->
                schemas
                    .choices()
                    .forEach(
                        choice -> choice.schemas().forEach(s -> known.putIfAbsent(s, object))));
    Set<String> explained = new HashSet<>();
    known.forEach(
        (schema, object) -> {
          if (!activated.containsKey(schema)
              && !almost(schema, object, activated.keySet(), explained, findings)
              && !shownFromTheStart(scene, schema)) {
            findings.add(SchemaRules.OF_NO_AREA, object, schema);
          }
        });
    activated.forEach(
        (schema, sensor) -> {
          if (!known.containsKey(schema)
              && !explained.contains(schema)
              && !almost(schema, sensor, known.keySet(), explained, findings)
              && entered.containsKey(schema)) {
            findings.add(SchemaRules.OF_NO_SWITCH, sensor, schema);
          }
        });
  }

  private static boolean almost(
      String schema,
      ParsedNode at,
      Collection<String> others,
      Set<String> explained,
      Findings findings) {
    Optional<String> meant = SchemaNames.probablyMeant(schema, new TreeSet<>(others));
    meant.ifPresent(
        other -> {
          findings.add(SchemaRules.ALMOST_THE_SAME, at, schema, other);
          explained.add(other);
        });
    return meant.isPresent();
  }

  private static boolean shownFromTheStart(EnrichedScene scene, String schema) {
    return scene.objects().entrySet().stream()
        .allMatch(entry -> shown(entry.getKey(), entry.getValue(), schema));
  }

  private static boolean shown(ParsedNode object, SwitchSchemas schemas, String schema) {
    return schemas.choices().stream()
        .filter(choice -> choice.schemas().contains(schema))
        .allMatch(choice -> choice.index() == object.integer("whichChoice"));
  }
}

package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The schemas of an area as texts that an author edits; works like {@link MetadataFormModel}. */
final class SensorFormModel {
  private final EnricherSession session;
  private final DocumentElement element;

  /**
   * @param element a ProximitySensor
   */
  SensorFormModel(EnricherSession session, DocumentElement element) {
    this.session = session;
    this.element = element;
  }

  private SensorSchemas schemas() {
    return session
        .enrichment()
        .sensorNode(element)
        .map(EnrichedSensor::schemas)
        .orElse(new SensorSchemas(List.of(), List.of()));
  }

  String enter() {
    return SchemaListFormat.format(schemas().enter());
  }

  String exit() {
    return SchemaListFormat.format(schemas().exit());
  }

  /** Sets the schemas that entering activates; returns what is wrong with the text. */
  Optional<String> enter(String text) {
    return write(text, names -> new SensorSchemas(names, schemas().exit()));
  }

  /** Sets the schemas that leaving activates; returns what is wrong with the text. */
  Optional<String> exit(String text) {
    return write(text, names -> new SensorSchemas(schemas().enter(), names));
  }

  private Optional<String> write(String text, Function<List<String>, SensorSchemas> with) {
    ParseResult<List<String>> input = SchemaListFormat.parse(text);
    if (input instanceof ParseResult.Wrong<List<String>> wrong) {
      return Optional.of(wrong.why());
    }
    SensorSchemas wanted = with.apply(((ParseResult.Valid<List<String>>) input).value());
    session
        .enrichment()
        .sensorNode(element)
        .filter(now -> !now.schemas().equals(wanted))
        .ifPresent(
            now ->
                session.attempt(
                    () -> session.document().perform(session.edits().sensor(now, wanted))));
    return Optional.empty();
  }
}

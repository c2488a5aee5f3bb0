package org.selectiverenderer.enricher.overview;

import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.MetadataClipboardFormat;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Copies all metadata of an object or area to the system clipboard, and pastes it to others. */
public final class MetadataClipboard {
  private final EnricherSession session;
  private final Clipboard clipboard;

  public MetadataClipboard(EnricherSession session) {
    this(session, Toolkit.getDefaultToolkit().getSystemClipboard());
  }

  MetadataClipboard(EnricherSession session, Clipboard clipboard) {
    this.session = session;
    this.clipboard = clipboard;
  }

  /** Whether an element, or one around it, is an object or area, which can have metadata. */
  public boolean fits(DocumentElement element) {
    return enriched(element).isPresent();
  }

  /** Copies the metadata of the first of some elements, or of the Switch or sensor around it. */
  public void copy(List<DocumentElement> from) {
    Optional<String> text =
        from.stream()
            .findFirst()
            .flatMap(this::enriched)
            .flatMap(
                element ->
                    session
                        .enrichment()
                        .switchNode(element)
                        .map(MetadataClipboardFormat::of)
                        .or(
                            () ->
                                session
                                    .enrichment()
                                    .sensorNode(element)
                                    .map(MetadataClipboardFormat::of)));
    text.ifPresent(found -> clipboard.setContents(new StringSelection(found), null));
    session.message(Texts.of(text.isPresent() ? "overview.copied" : "overview.nocopy"));
  }

  /** Pastes the metadata to elements, or the Switches and sensors around them, as one undo step. */
  public void paste(List<DocumentElement> to) {
    List<EnrichedSwitch> objects = new ArrayList<>();
    List<EnrichedSensor> areas = new ArrayList<>();
    to.stream()
        .flatMap(each -> enriched(each).stream())
        .distinct()
        .forEach(
            element -> {
              session.enrichment().switchNode(element).ifPresent(objects::add);
              session.enrichment().sensorNode(element).ifPresent(areas::add);
            });
    session.attempt(
        () ->
            session
                .document()
                .perform(
                    MetadataClipboardFormat.paste(session.enrichment(), text(), objects, areas)));
  }

  private String text() {
    try {
      return String.valueOf(clipboard.getData(DataFlavor.stringFlavor));
    } catch (UnsupportedFlavorException | IOException | IllegalStateException e) {
      throw new EditRejectedException(Texts.of("overview.notext"));
    }
  }

  /** The nearest Switch or sensor: the element itself or one around it. */
  private Optional<DocumentElement> enriched(DocumentElement element) {
    Optional<DocumentElement> at = Optional.of(element);
    while (at.isPresent()
        && session.enrichment().switchNode(at.get()).isEmpty()
        && session.enrichment().sensorNode(at.get()).isEmpty()) {
      at = at.get().parent();
    }
    return at;
  }
}

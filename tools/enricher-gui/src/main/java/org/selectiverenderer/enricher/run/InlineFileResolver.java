package org.selectiverenderer.enricher.run;

import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.AccessHint;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Resolves the file that an Inline of a document names. */
public final class InlineFileResolver {
  /**
   * The resolved file, or why there is none.
   *
   * @param file the file; empty when there is none to open
   * @param reason a sentence why there is none
   */
  public record Answer(Optional<Path> file, String reason) {}

  private InlineFileResolver() {}

  /**
   * Resolves the first url, of an Inline or of the first Inline in an element, that is allowed and
   * names a file on this computer.
   */
  public static Answer of(EnricherSession session, DocumentElement element) {
    Optional<DocumentElement> inline = inline(element);
    if (inline.isEmpty()) {
      return new Answer(Optional.empty(), Texts.of("run.noinline"));
    }
    Path scene = session.file().path().toAbsolutePath();
    Path folder = scene.getParent() == null ? scene : scene.getParent();
    UrlResolver root = new UrlResolver(folder, session.access());
    String reason = Texts.of("run.nourl");
    for (String url :
        MFStringParser.strings(session.document().attribute(inline.get(), "url").orElse(""))) {
      UrlResolver.Target target = root.resolve(url, folder);
      if (target instanceof UrlResolver.Target.Found found && found.content().file().isPresent()) {
        return new Answer(found.content().file(), "");
      }
      if (target instanceof UrlResolver.Target.Refused refused) {
        reason = AccessHint.inWindow(url + " " + refused.reason());
      }
    }
    return new Answer(Optional.empty(), reason);
  }

  /** Whether an element is or holds an Inline. */
  public static boolean holds(DocumentElement element) {
    return inline(element).isPresent();
  }

  private static Optional<DocumentElement> inline(DocumentElement element) {
    return element.name().equals("Inline")
        ? Optional.of(element)
        : element.children().stream().flatMap(child -> inline(child).stream()).findFirst();
  }
}

package org.selectiverenderer.models;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ModelFileSource;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The files that a model of another program may read: itself, and what {@link UrlResolver} lets a
 * scene in its folder refer to. Collects what is refused.
 */
final class ModelFileAccess implements ModelFileSource {
  private static final int SHOWN = 80;
  private static final Pattern SLASHES = Pattern.compile("[/\\\\]+");

  private record Refusal(UrlResolver.Cause cause, String reason) {}

  private final ModelSource model;
  private final Optional<UrlResolver> root;
  private final Map<String, Refusal> refused = new LinkedHashMap<>();

  ModelFileAccess(ModelSource model, Optional<UrlResolver> root) {
    this.model = model;
    this.root = root;
  }

  @Override
  public Optional<OpenFile> open(String url) throws IOException {
    if (url.equals(model.fileName())) {
      return Optional.of(model.content().open());
    }
    // Formats other than X3D have no fragments.
    if (root.isEmpty()) {
      if (!guessed(url)) {
        String reason = "is another file, and the model is read without its folder";
        refused.put(url, new Refusal(UrlResolver.Cause.MISSING, reason));
      }
      return Optional.empty();
    }
    UrlResolver.Target target = root.get().resolve(url.replace("#", "%23"), model.base());
    if (target instanceof UrlResolver.Target.Refused why) {
      if (!guessed(url)) {
        refused.put(url, new Refusal(why.cause(), why.reason()));
      }
      return Optional.empty();
    }
    UrlContent content = ((UrlResolver.Target.Found) target).content();
    return Optional.of(
        MaterialLibraryDialect.corrected(
            url,
            content.file().isPresent()
                ? ModelSource.open(content.file().get())
                : new OpenFile(content.size(), content.open())));
  }

  /**
   * Returns whether a url is not the file's own: for a file that it does not get, Assimp asks again
   * with a dot before the url, and with a part of it. On Windows it does so with backslashes.
   */
  private boolean guessed(String url) {
    String attempt = withSingleSlashes(url);
    return refused.keySet().stream()
        .anyMatch(known -> attempt.startsWith("./") || withSingleSlashes(known).endsWith(attempt));
  }

  private static String withSingleSlashes(String url) {
    return SLASHES.matcher(url).replaceAll("/");
  }

  /**
   * Reports what was refused, but a file that is missing only if it was the first: for a material
   * file that it does not get, Assimp asks for one named as the model.
   *
   * @param consequence what follows from it
   * @return whether there was any
   */
  boolean report(Problem.Severity severity, String consequence, ProblemCollector problems) {
    boolean first = true;
    for (Map.Entry<String, Refusal> entry : refused.entrySet()) {
      boolean absent =
          entry.getValue().cause() == UrlResolver.Cause.MISSING
              || entry.getValue().cause() == UrlResolver.Cause.CASE;
      if (absent && !first) {
        continue;
      }
      first = false;
      String url = entry.getKey();
      problems.add(
          new Problem(
              absent ? severity : Problem.Severity.ERROR,
              SourceLocation.of(model.name()),
              "url '%s' %s; %s"
                  .formatted(
                      url.length() <= SHOWN ? url : url.substring(0, SHOWN) + "…",
                      entry.getValue().reason(),
                      consequence)));
    }
    return !refused.isEmpty();
  }
}

package org.selectiverenderer.authoring.qualities;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.FieldQualityEdits;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.ReferencingScenes;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Plans smaller pictures of the ImageTextures of an object. */
final class TextureLevels {
  private final SceneDocument document;
  private final NodeNaming names;
  private final Path folder;
  private final UrlResolver urls;
  private final PictureScaler scaler;
  private final ReferencingScenes others;
  private final ProblemCollector problems;
  private final Map<Path, PlannedFile> files = new HashMap<>();

  /** The original of each planned picture. */
  private final Map<Path, Path> originals = new HashMap<>();

  TextureLevels(
      SceneDocument document,
      NodeNaming names,
      Path folder,
      UrlResolver urls,
      PictureScaler scaler,
      ReferencingScenes others,
      ProblemCollector problems) {
    this.document = document;
    this.names = names;
    this.folder = folder;
    this.urls = urls;
    this.scaler = scaler;
    this.others = others;
    this.problems = problems;
  }

  /**
   * @param percents of each side, the best level's first
   * @param schemas one for the original and each percent, or none
   * @throws IOException if a picture cannot be read or a file is in the way, with a one-line
   *     message that names it
   */
  QualityLevels of(DocumentElement object, List<Double> percents, List<String> schemas, String name)
      throws IOException {
    List<FieldQuality> qualities = new ArrayList<>();
    List<TextEdit> changes = new ArrayList<>();
    Set<String> known = new HashSet<>();
    new FieldQualityEdits(document)
        .of(object).stream()
            .flatMap(quality -> quality.levels().stream().skip(1)) // the first is the author's own
            .forEach(level -> known.addAll(level.values()));
    for (DocumentElement texture : names.own(object, "ImageTexture")) {
      List<String> written = texture.text("url").map(MFStringParser::strings).orElse(List.of());
      int first = local(written);
      if (first < 0) {
        problems.warning(
            texture.location(),
            "no url of this ImageTexture is a file of this scene; it gets no smaller picture");
        continue;
      }
      Path picture = file(written.get(first));
      List<List<String>> values = new ArrayList<>();
      values.add(written);
      for (double percent : percents) {
        String url = smaller(picture, percent, known);
        values.add(List.of(url));
      }
      qualities.add(
          new FieldQuality(
              Quality.TEXTURES,
              new FieldReference(names.of(texture, name + "_Texture", changes), "url"),
              LevelMetadata.levels(values, schemas)));
    }
    return new QualityLevels(qualities, changes, List.copyOf(files.values()));
  }

  /** Returns the index of the first url that is a file which the scene may read; -1 for none. */
  private int local(List<String> written) {
    for (int i = 0; i < written.size(); i++) {
      if (urls.resolve(written.get(i), folder) instanceof UrlResolver.Target.Found found
          && found.content() instanceof UrlContent.OfFile) {
        return i;
      }
    }
    return -1;
  }

  private Path file(String url) {
    return urls.resolve(url, folder) instanceof UrlResolver.Target.Found found
            && found.content() instanceof UrlContent.OfFile file
        ? file.path()
        : folder;
  }

  /** Plans one picture beside the original; returns its url. */
  private String smaller(Path picture, double percent, Set<String> known) throws IOException {
    String name = String.valueOf(picture.getFileName());
    int dot = name.lastIndexOf('.');
    String ending = dot < 0 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
    boolean jpeg = List.of(".jpg", ".jpeg", ".jpe").contains(ending);
    String base = dot < 0 ? name : name.substring(0, dot);
    String number = (DecimalRounding.to(3, percent) + "").replaceFirst("\\.0$", "");
    byte[] content = null;
    for (int attempt = 1; ; attempt++) {
      Path to =
          picture.resolveSibling(
              base + "_" + number + (attempt == 1 ? "" : "_" + attempt) + (jpeg ? ending : ".png"));
      String url = UrlRelativizer.between(folder, to);
      Path original = originals.putIfAbsent(to, picture);
      if (original != null && !original.equals(picture)) {
        throw new IOException(
            "%s and %s would both become %s; rename one of them".formatted(original, picture, to));
      }
      if (files.containsKey(to)) {
        return url;
      }
      content = content == null ? scaler.scaled(picture, percent) : content;
      boolean there = Files.exists(to, LinkOption.NOFOLLOW_LINKS);
      boolean same = there && Files.isRegularFile(to) && same(content, to);
      Optional<Path> other = there && !same ? others.of(to) : Optional.empty();
      if (other.isPresent()) {
        problems.info(
            SourceLocation.of(to.toString()),
            "%s shows the picture, so it stays as it is; the level gets a new one of another name"
                .formatted(other.get()));
        originals.remove(to);
        continue;
      }
      if (there && !same && !known.contains(url)) {
        throw new IOException(
            to + " exists already and is another picture; move it away, or choose another percent");
      }
      files.put(
          to,
          new PlannedFile(
              to,
              content,
              same
                  ? PlannedFile.State.UNCHANGED
                  : there ? PlannedFile.State.CHANGED : PlannedFile.State.NEW,
              there && !same)); // it may have been painted over
      return url;
    }
  }

  private static boolean same(byte[] content, Path file) throws IOException {
    return Files.size(file) == content.length && Arrays.equals(content, Files.readAllBytes(file));
  }
}

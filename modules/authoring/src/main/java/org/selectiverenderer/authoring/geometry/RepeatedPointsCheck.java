package org.selectiverenderer.authoring.geometry;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.selectiverenderer.authoring.DocumentCheck;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * A check that finds faces whose points repeat others and could be welded. A few faces are listed
 * one by one; more than one of them also in a single finding of the scene, at its root. It
 * remembers what it found in faces, so that only those that changed are searched anew. Thread-safe.
 */
public final class RepeatedPointsCheck implements DocumentCheck {
  /**
   * The id of the rule, which is in the validator's catalogue, though the validator has no check.
   */
  public static final String RULE = "SR208";

  private static final String ADVICE =
      "; welded, the file is smaller and looks the same [" + RULE + "]";

  /** The most faces that are listed one by one. */
  private static final int FEW = 3;

  /** A result of one mesh depends on the text of its faces alone. */
  private record Repeated(int welded, int points, double tolerance) {
    static final Repeated NONE = new Repeated(0, 0, 0);
  }

  private record Found(DocumentElement faces, Repeated points) {}

  private final long mostInAll;
  private final Consumer<DocumentElement> onSearch;

  /** The results of the last whole check are kept by the digest of the text of faces. */
  private volatile Map<String, Repeated> known = Map.of();

  /** Searches the faces of scenes. */
  public RepeatedPointsCheck() {
    this(WeldableFaces.MOST_IN_ALL, faces -> {});
  }

  /**
   * @param mostInAll the most characters of faces that are searched in a scene
   * @param onSearch is given each faces that are searched, not those that are remembered
   */
  RepeatedPointsCheck(long mostInAll, Consumer<DocumentElement> onSearch) {
    this.mostInAll = mostInAll;
    this.onSearch = onSearch;
  }

  @Override
  public List<Problem> check(DocumentSnapshot snapshot) {
    ElementTree tree;
    try {
      tree = snapshot.elements();
    } catch (XmlParseException e) {
      return List.of(); // reported by others
    }
    NodeConnections connections = new NodeConnections();
    Map<String, Repeated> now = new HashMap<>();
    List<Found> found = new ArrayList<>();
    for (DocumentElement each : new WeldableFaces(snapshot.text(), tree, mostInAll).list()) {
      if (Thread.currentThread().isInterrupted()) {
        throw new CancellationException();
      }
      try {
        PointWelding.refuseConnected(tree, connections, each);
      } catch (EditRejectedException e) {
        continue;
      }
      Repeated repeated = repeated(snapshot.text(), each, now);
      if (repeated.welded() > 0) {
        found.add(new Found(each, repeated));
      }
    }
    known = Map.copyOf(now);
    return problems(snapshot.name(), found);
  }

  private Repeated repeated(String text, DocumentElement faces, Map<String, Repeated> now) {
    String own = text.substring(faces.start(), faces.end());
    if (own.indexOf('&') >= 0) {
      return search(text, faces); // an entity has its value elsewhere
    }
    String key = Sha256.of(own.getBytes(StandardCharsets.UTF_8));
    Repeated before = known.get(key);
    Repeated repeated = before != null ? before : search(text, faces);
    now.put(key, repeated);
    return repeated;
  }

  private Repeated search(String text, DocumentElement faces) {
    onSearch.accept(faces);
    try {
      PointWelding welding = PointWelding.ofItself(text, faces);
      return new Repeated(welding.welded(), welding.points(), welding.tolerance());
    } catch (EditRejectedException e) {
      return Repeated.NONE;
    }
  }

  private static List<Problem> problems(String file, List<Found> found) {
    List<Problem> problems = new ArrayList<>();
    if (found.size() > 1) {
      long points = found.stream().mapToLong(each -> each.points().welded()).sum();
      DocumentElement first = found.get(0).faces();
      problems.add(
          remark(
              SourceLocation.of(file),
              String.format(
                  Locale.ROOT,
                  "%d meshes hold %d repeated points, first %s in line %d",
                  found.size(),
                  points,
                  first,
                  first.location().line())));
    }
    if (found.size() <= FEW) {
      found.forEach(each -> problems.add(remark(each.faces().location(), sentence(each))));
    }
    return problems;
  }

  private static String sentence(Found found) {
    Repeated points = found.points();
    return String.format(
        Locale.ROOT,
        "%d of %d points of %s repeat another%s",
        points.welded(),
        points.points(),
        found.faces(),
        points.tolerance() > 0 ? " within " + WeldingTolerance.text(points.tolerance()) : "");
  }

  private static Problem remark(SourceLocation at, String sentence) {
    return new Problem(Problem.Severity.INFO, at, sentence + ADVICE);
  }
}

package org.selectiverenderer.authoring.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.selectiverenderer.authoring.DocumentCheck;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.XmlParseException;

/** A check that finds faces whose points repeat others and could be welded. */
public final class RepeatedPointsCheck implements DocumentCheck {
  /** The end of each message, by which the fix is known. */
  static final String ADVICE = "; welded, the file is smaller and looks the same";

  /** Faces with more text than this are not searched, so that a large scene is checked soon. */
  private static final int MOST = 4_000_000;

  /** Faces beyond this much text in all are not searched, as each pause in editing begins anew. */
  private static final long MOST_IN_ALL = 12_000_000;

  private final long mostInAll;

  /** Searches the faces of scenes. */
  public RepeatedPointsCheck() {
    this(MOST_IN_ALL);
  }

  /**
   * @param mostInAll the most characters of faces that are searched in a scene
   */
  RepeatedPointsCheck(long mostInAll) {
    this.mostInAll = mostInAll;
  }

  @Override
  public List<Problem> check(DocumentSnapshot snapshot) {
    ElementTree tree;
    try {
      tree = snapshot.elements();
    } catch (XmlParseException e) {
      return List.of(); // reported by others
    }
    List<DocumentElement> faces = new ArrayList<>();
    tree.root()
        .visit(
            element -> {
              if (GeometryRepair.INDEXED.contains(element.name())
                  && element.end() - element.start() < MOST) {
                faces.add(element);
              }
            });
    NodeConnections connections = new NodeConnections();
    List<Problem> problems = new ArrayList<>();
    long searched = 0;
    for (DocumentElement each : faces) {
      if (Thread.currentThread().isInterrupted()) {
        throw new CancellationException();
      }
      searched += each.end() - each.start();
      if (searched > mostInAll) {
        break;
      }
      PointWelding.finding(snapshot.text(), tree, connections, each)
          .ifPresent(
              message ->
                  problems.add(new Problem(Problem.Severity.INFO, each.location(), message)));
    }
    return problems;
  }
}

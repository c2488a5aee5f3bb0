package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.model.ModelReader;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dReader;

/**
 * Makes versions of an object in a scene (thesis 4.2): in the object's place comes a Switch of
 * Inlines, each of which names a file with one version. The original becomes version 1 as it is;
 * the others are reduced. A Transform around the object stays where it was, and so does every other
 * byte of the scene. An object that has versions already gets new ones of its version 1.
 */
public final class VersionMaker {
  private final X3dReader reader;
  private final ModelReader models;

  public VersionMaker(NodeCatalogue catalogue) {
    this.reader = new X3dReader(catalogue);
    this.models = new ModelReader(catalogue);
  }

  /**
   * What is to be done.
   *
   * @param object the DEF name of the object, or of the Transform or Group round it
   * @param goals of versions 2, 3 and so on; a first one that is all of the original stands for
   *     version 1
   * @param output the changed scene; the scene itself to change it in place
   * @param inlineFolder where the versions' files go, relative to the output's folder
   */
  public record Request(
      Path scene, String object, List<Goal> goals, Path output, String inlineFolder) {
    public Request {
      goals = List.copyOf(goals);
    }
  }

  /**
   * Works out what to write, and writes nothing.
   *
   * @return empty when the object cannot get versions, which is reported as a problem
   * @throws BadSceneException if the scene's text cannot be changed without harm
   * @throws IOException if the scene cannot be read
   */
  public Optional<VersionPlan> plan(Request request, Problems problems) throws IOException {
    return plan(request, SceneSource.read(request.scene(), reader, problems), problems);
  }

  /**
   * The same for a scene that is open in an editor.
   *
   * @param bytes of the scene as it is there
   */
  public Optional<VersionPlan> plan(Request request, byte[] bytes, Problems problems)
      throws IOException {
    return plan(request, SceneSource.of(request.scene(), bytes, reader, problems), problems);
  }

  private Optional<VersionPlan> plan(Request request, SceneSource scene, Problems problems)
      throws IOException {
    Optional<ObjectSite> site = new SiteFinder(scene, problems).find(request.object());
    if (site.isEmpty()) {
      return Optional.empty();
    }
    return new Planning(request, scene, site.get(), models, reader, problems).plan();
  }
}

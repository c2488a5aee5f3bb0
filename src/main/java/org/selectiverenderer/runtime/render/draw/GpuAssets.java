package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.TextureFilters;
import org.selectiverenderer.runtime.render.light.LightPlanner;
import org.selectiverenderer.runtime.render.light.Lighting;
import org.selectiverenderer.runtime.render.light.MeshForm;
import org.selectiverenderer.runtime.render.light.MeshSurvey;
import org.selectiverenderer.runtime.render.mesh.MeshPacker;
import org.selectiverenderer.runtime.render.mesh.PackedMesh;
import org.selectiverenderer.runtime.render.mesh.StagedMesh;
import org.selectiverenderer.runtime.render.occlude.Occluders;

/**
 * The resources on the graphics card: batches of small shapes, other meshes once however many
 * shapes use them, and the draw states of shapes.
 */
final class GpuAssets {
  private final LightPlanner planner;
  private final Map<MeshForm, Uploaded> meshes = new HashMap<>();
  private final List<GpuMesh> merged = new ArrayList<>();
  private final DrawLooks looks;
  private long uploads;

  private record Uploaded(MeshPart part, MeshSurvey survey) {}

  /** A mesh in the form in which it is drawn. */
  private record Drawn(MeshForm form, StagedMesh staged, MeshSurvey survey) {
    Mesh mesh() {
      return staged.mesh();
    }
  }

  private record Packed(Drawn drawn, PackedMesh mesh) {}

  GpuAssets(LightPlanner planner, TextureFilters filters) {
    this.planner = planner;
    looks = new DrawLooks(filters);
  }

  /** Returns the number of meshes and textures uploaded since the start. */
  long uploads() {
    return uploads + looks.uploads();
  }

  /**
   * Decides how shapes are lit and uploads what they draw; new meshes are measured, refined and
   * packed in parallel on all processors.
   *
   * @param together whether small shapes of equal draw state are put into batches
   * @return one item for each request, in the same order
   */
  List<DrawItem> prepare(GL3 gl, List<LightPlanner.Request> requests, boolean together) {
    if (requests.isEmpty()) {
      return List.of();
    }
    Map<Mesh, MeshSurvey> surveys = surveys(requests);
    List<LightPlanner.Plan> plans =
        requests.parallelStream()
            .map(request -> planner.plan(request, surveys.get(request.mesh())))
            .toList();
    Map<MeshForm, Drawn> drawn = drawn(plans, surveys, together);
    List<BatchPlan.Candidate> shapes = new ArrayList<>(plans.size());
    for (LightPlanner.Plan plan : plans) {
      Drawn of = drawn.get(plan.form());
      List<LightInstance> reaching = looks.shared(plan.reaching());
      Lighting lighting = plan.lighting(of.survey(), reaching);
      ShapeInstance shape = plan.request().shape();
      DrawLook look = looks.of(gl, shape, of.mesh(), reaching);
      shapes.add(new BatchPlan.Candidate(shapes.size(), shape, of.staged(), look, lighting));
    }
    Map<ShapeInstance, MeshPart> parts =
        together ? uploadBatches(gl, shapes) : new IdentityHashMap<>();
    Map<MeshForm, Drawn> missing = new LinkedHashMap<>();
    for (LightPlanner.Plan plan : plans) {
      if (!parts.containsKey(plan.request().shape()) && !meshes.containsKey(plan.form())) {
        missing.put(plan.form(), drawn.get(plan.form()));
      }
    }
    upload(gl, missing);
    List<DrawItem> items = new ArrayList<>(plans.size());
    for (int i = 0; i < plans.size(); i++) {
      LightPlanner.Request request = plans.get(i).request();
      MeshPart part = parts.get(request.shape());
      items.add(
          item(
              shapes.get(i),
              request.mesh(),
              part == null ? meshes.get(plans.get(i).form()).part() : part));
    }
    return items;
  }

  private Map<Mesh, MeshSurvey> surveys(List<LightPlanner.Request> requests) {
    Set<Mesh> distinct = Collections.newSetFromMap(new IdentityHashMap<>());
    requests.forEach(request -> distinct.add(request.mesh()));
    Map<Mesh, MeshSurvey> surveys = new IdentityHashMap<>();
    distinct.parallelStream()
        .map(mesh -> Map.entry(mesh, planner.survey(mesh)))
        .toList()
        .forEach(surveyed -> surveys.put(surveyed.getKey(), surveyed.getValue()));
    return surveys;
  }

  private Map<MeshForm, Drawn> drawn(
      List<LightPlanner.Plan> plans, Map<Mesh, MeshSurvey> surveys, boolean together) {
    Map<MeshForm, LightPlanner.Plan> distinct = new LinkedHashMap<>();
    plans.forEach(plan -> distinct.putIfAbsent(plan.form(), plan));
    return distinct.values().parallelStream()
        .map(plan -> drawn(plan, surveys, together))
        .collect(Collectors.toMap(Drawn::form, mesh -> mesh));
  }

  private Drawn drawn(LightPlanner.Plan plan, Map<Mesh, MeshSurvey> surveys, boolean together) {
    Mesh source = plan.form().source();
    Uploaded uploaded = meshes.get(plan.form());
    if (uploaded != null && !together) {
      // Only the mesh's layout is needed, which is that of its source: it need not be refined
      // again.
      return new Drawn(plan.form(), StagedMesh.of(source), uploaded.survey());
    }
    StagedMesh staged = plan.refined() == null ? LightPlanner.mesh(plan.form()) : plan.refined();
    Mesh mesh = staged.mesh();
    return new Drawn(
        plan.form(), staged, mesh == source ? surveys.get(source) : planner.survey(mesh));
  }

  private Map<ShapeInstance, MeshPart> uploadBatches(GL3 gl, List<BatchPlan.Candidate> candidates) {
    Map<ShapeInstance, MeshPart> parts = new IdentityHashMap<>();
    BatchPlan.of(candidates).parallelStream()
        .map(PackedBatch::pack)
        .toList()
        .forEach(
            batch -> {
              GpuMesh gpu = new GpuMesh(gl, batch.merged().mesh());
              merged.add(gpu);
              uploads++;
              batch.parts(gpu, parts);
            });
    return parts;
  }

  private void upload(GL3 gl, Map<MeshForm, Drawn> missing) {
    missing.values().parallelStream()
        .map(drawn -> new Packed(drawn, MeshPacker.pack(drawn.staged())))
        .toList()
        .forEach(
            packed -> {
              MeshForm form = packed.drawn().form();
              // The refined triangles cover the same surface as the mesh's own.
              Occluders occluders = Occluders.of(form.source());
              MeshPart part = MeshPart.whole(new GpuMesh(gl, packed.mesh()), occluders);
              meshes.put(form, new Uploaded(part, packed.drawn().survey()));
              uploads++;
            });
  }

  private DrawItem item(BatchPlan.Candidate shape, Mesh source, MeshPart part) {
    DrawBatch batch = part.batch();
    DrawLook look = batch != null && batch.tinted() ? looks.tinted(shape.look()) : shape.look();
    return new DrawItem(
        shape.shape(),
        source,
        shape.shape().surface(),
        part,
        look.texture(),
        look.byPixel(),
        look.byVertex(),
        shape.lighting(),
        look.material().array(),
        look.textureTransform().array(),
        look.blended(),
        Strokes.form(look.stroke(), look.primitive()),
        shape.shape().stroke(),
        shape.shape().surroundings(),
        looks.rank(look),
        look.detail(),
        look.author());
  }

  /** Frees the resources that none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    Set<GpuMesh> used = new HashSet<>();
    items.forEach(item -> used.add(item.mesh()));
    merged.removeIf(mesh -> dispose(gl, mesh, used));
    meshes.values().removeIf(uploaded -> dispose(gl, uploaded.part().mesh(), used));
    looks.keepOnly(gl, items);
  }

  private static boolean dispose(GL3 gl, GpuMesh mesh, Set<GpuMesh> used) {
    boolean unused = !used.contains(mesh);
    if (unused) {
      mesh.dispose(gl);
    }
    return unused;
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    looks.dispose(gl);
  }
}

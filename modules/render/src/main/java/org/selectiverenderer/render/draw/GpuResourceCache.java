package org.selectiverenderer.render.draw;

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
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.BufferPool;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.TextureFilterQuality;
import org.selectiverenderer.render.lighting.LightingPlanner;
import org.selectiverenderer.render.lighting.MeshMetrics;
import org.selectiverenderer.render.lighting.RefinedMeshKey;
import org.selectiverenderer.render.lighting.ShapeLighting;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.render.mesh.RefinedMesh;
import org.selectiverenderer.render.occlusion.MeshOccluders;

/**
 * The resources on the graphics card: batches of small shapes, other meshes once however many
 * shapes use them, and the draw states of shapes.
 */
final class GpuResourceCache {
  private final LightingPlanner planner;
  private final Map<RefinedMeshKey, Uploaded> meshes = new HashMap<>();
  private final List<GpuMesh> merged = new ArrayList<>();
  private final BufferPool buffers = new BufferPool();
  private final DrawStateCache looks;
  private final BackgroundPacker packer;
  private long uploads;

  private record Uploaded(SubMesh part, MeshMetrics survey) {}

  /** A mesh in the form in which it is drawn. */
  private record Drawn(RefinedMeshKey form, RefinedMesh staged, MeshMetrics survey) {
    Mesh mesh() {
      return staged.mesh();
    }
  }

  private record Packed(Drawn drawn, PackedMesh mesh, MeshOccluders occluders) {}

  GpuResourceCache(LightingPlanner planner, TextureFilterQuality filters) {
    this.planner = planner;
    looks = new DrawStateCache(filters);
    packer = new BackgroundPacker(planner::survey);
  }

  /**
   * Returns whether a frame can take in a mesh without waiting for long; if not, it is packed
   * meanwhile.
   */
  boolean ready(Mesh mesh) {
    return mesh.polygons() <= LightingPlanner.HEAVY
        || meshes.containsKey(RefinedMeshKey.plain(mesh))
        || packer.ready(mesh);
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
  List<DrawItem> prepare(GL3 gl, List<LightingPlanner.Request> requests, boolean together) {
    if (requests.isEmpty()) {
      return List.of();
    }
    Map<Mesh, MeshMetrics> surveys = surveys(requests);
    List<LightingPlanner.Plan> plans =
        requests.parallelStream()
            .map(request -> planner.plan(request, surveys.get(request.mesh())))
            .toList();
    Map<RefinedMeshKey, Drawn> drawn = drawn(plans, surveys, together);
    List<BatchPlanner.Candidate> shapes = new ArrayList<>(plans.size());
    for (LightingPlanner.Plan plan : plans) {
      Drawn of = drawn.get(plan.form());
      List<LightInstance> reaching = looks.shared(plan.reaching());
      ShapeLighting lighting = plan.lighting(of.survey(), reaching);
      ShapeInstance shape = plan.request().shape();
      DrawState look = looks.of(gl, shape, of.mesh(), reaching);
      shapes.add(new BatchPlanner.Candidate(shapes.size(), shape, of.staged(), look, lighting));
    }
    Map<ShapeInstance, SubMesh> parts =
        together ? uploadBatches(gl, shapes) : new IdentityHashMap<>();
    Map<RefinedMeshKey, Drawn> missing = new LinkedHashMap<>();
    for (LightingPlanner.Plan plan : plans) {
      if (!parts.containsKey(plan.request().shape()) && !meshes.containsKey(plan.form())) {
        missing.put(plan.form(), drawn.get(plan.form()));
      }
    }
    upload(gl, missing);
    List<DrawItem> items = new ArrayList<>(plans.size());
    for (int i = 0; i < plans.size(); i++) {
      LightingPlanner.Request request = plans.get(i).request();
      SubMesh part = parts.get(request.shape());
      items.add(
          item(
              shapes.get(i),
              request.mesh(),
              part == null ? meshes.get(plans.get(i).form()).part() : part));
    }
    return items;
  }

  /**
   * Forgets what was packed of other meshes.
   *
   * @param waiting a set by identity of the meshes that may still be wanted
   */
  void keepPacked(Set<Mesh> waiting) {
    packer.keepOnly(waiting);
  }

  /** Forgets what was packed of a mesh, which is uploaded or no longer wanted. */
  void forgetPacked(Mesh mesh) {
    packer.forget(mesh);
  }

  private Map<Mesh, MeshMetrics> surveys(List<LightingPlanner.Request> requests) {
    Set<Mesh> distinct = Collections.newSetFromMap(new IdentityHashMap<>());
    requests.forEach(request -> distinct.add(request.mesh()));
    Map<Mesh, MeshMetrics> surveys = new IdentityHashMap<>();
    distinct.parallelStream()
        .map(mesh -> Map.entry(mesh, survey(mesh)))
        .toList()
        .forEach(surveyed -> surveys.put(surveyed.getKey(), surveyed.getValue()));
    return surveys;
  }

  private MeshMetrics survey(Mesh mesh) {
    BackgroundPacker.Packed packed = packer.of(mesh);
    return packed == null ? planner.survey(mesh) : packed.survey();
  }

  private Map<RefinedMeshKey, Drawn> drawn(
      List<LightingPlanner.Plan> plans, Map<Mesh, MeshMetrics> surveys, boolean together) {
    Map<RefinedMeshKey, LightingPlanner.Plan> distinct = new LinkedHashMap<>();
    plans.forEach(plan -> distinct.putIfAbsent(plan.form(), plan));
    return distinct.values().parallelStream()
        .map(plan -> drawn(plan, surveys, together))
        .collect(Collectors.toMap(Drawn::form, mesh -> mesh));
  }

  private Drawn drawn(LightingPlanner.Plan plan, Map<Mesh, MeshMetrics> surveys, boolean together) {
    Mesh source = plan.form().source();
    Uploaded uploaded = meshes.get(plan.form());
    if (uploaded != null && !together) {
      // Only the mesh's layout is needed, which is that of its source: it need not be refined
      // again.
      return new Drawn(plan.form(), RefinedMesh.of(source), uploaded.survey());
    }
    RefinedMesh staged =
        plan.refined() == null ? LightingPlanner.mesh(plan.form()) : plan.refined();
    Mesh mesh = staged.mesh();
    return new Drawn(
        plan.form(), staged, mesh == source ? surveys.get(source) : planner.survey(mesh));
  }

  private Map<ShapeInstance, SubMesh> uploadBatches(
      GL3 gl, List<BatchPlanner.Candidate> candidates) {
    Map<ShapeInstance, SubMesh> parts = new IdentityHashMap<>();
    BatchPlanner.of(candidates).parallelStream()
        .map(PackedBatch::pack)
        .toList()
        .forEach(
            batch -> {
              GpuMesh gpu = new GpuMesh(gl, batch.merged().mesh(), buffers);
              merged.add(gpu);
              uploads++;
              batch.parts(gpu, parts);
            });
    return parts;
  }

  private void upload(GL3 gl, Map<RefinedMeshKey, Drawn> missing) {
    missing.values().parallelStream()
        .map(this::packed)
        .toList()
        .forEach(
            packed -> {
              RefinedMeshKey form = packed.drawn().form();
              packer.forget(form.source());
              SubMesh part =
                  SubMesh.whole(new GpuMesh(gl, packed.mesh(), buffers), packed.occluders());
              meshes.put(form, new Uploaded(part, packed.drawn().survey()));
              uploads++;
            });
  }

  private Packed packed(Drawn drawn) {
    RefinedMeshKey form = drawn.form();
    BackgroundPacker.Packed ahead = form.isPlain() ? packer.of(form.source()) : null;
    return ahead == null
        // The refined triangles cover the same surface as the mesh's own.
        ? new Packed(drawn, MeshPacker.pack(drawn.staged()), MeshOccluders.of(form.source()))
        : new Packed(drawn, ahead.mesh(), ahead.occluders());
  }

  private DrawItem item(BatchPlanner.Candidate shape, Mesh source, SubMesh part) {
    DrawBatch batch = part.batch();
    DrawState look = batch != null && batch.tinted() ? looks.tinted(shape.look()) : shape.look();
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
        StrokePatterns.form(look.stroke(), look.primitive()),
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
    packer.close();
    keepOnly(gl, List.of());
    looks.dispose(gl);
    buffers.dispose(gl);
  }
}

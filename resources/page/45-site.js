// What lies around the structure: meshes, and the picture of the ground.
class Site {
    // @param pictured  address of the picture of the ground; null: there is none
    // @param arrived   called when that can be drawn
    constructor(arrays, facts, renderer, pictured, arrived) {
        this.solid = null;
        this.photo = null;
        this.points = new Float32Array(0);
        this.corners = new Uint32Array(0);
        const { site } = facts.scene;
        if (site !== null) {
            this.points = arrays.places('sitePoints', site.step);
            this.corners = arrays.steps('siteCorners', Uint32Array);
            this.solid = renderer.solid(this.points, this.corners);
        }
        if (pictured !== null && facts.ground.picture !== null) {
            this.take(renderer, pictured, facts.ground.picture, arrived);
        }
    }

    async take(renderer, source, { x0, y0, width, height }, arrived) {
        const image = new Image();
        image.src = source;
        await image.decode();
        this.photo = { texture: renderer.pictureOf(image), place: [x0, y0, 1 / width, 1 / height] };
        arrived();
    }

    get solids() {
        return this.solid ? [this.solid] : [];
    }

    // Nearest hit of a ray: its distance; null if it misses.
    meets(ray) {
        let nearest = null;
        const corner = (i) => [0, 1, 2].map((c) => this.points[3 * this.corners[i] + c]);
        for (let i = 0; i < this.corners.length; i += 3) {
            const distance = rayMeets(ray, [corner(i), corner(i + 1), corner(i + 2)], [[0, 1, 2]]);
            if (distance !== null && (nearest === null || distance < nearest)) {
                nearest = distance;
            }
        }
        return nearest;
    }
}

import { paintDoor } from '../core/Doors.js';
import { fadeImpostor } from '../core/GateImpostors.js';
import { loadPhase } from '../core/loadPhase.js';
import { recordFromMetadata } from '../core/recordMetadata.js';

/**
 * Shows and hides sectors' files as Inlines of the root world: Transform (the sector's origin) > Inline.
 *
 * Frame   origins in plan metres, [east, north]; the root world's axes are x = east, y = up, z = -north.
 * Differs paper 004 §5 deletes the Inline (VRML97); X3D has Inline.load, so the nodes stay and only the content goes.
 */
export class InlineSectors {
    /**
     * `scene` creates nodes; ids, inlines run in step: near files that the root world has a place for; `values`: { rotation,
     * color } of paintDoor.
     */
    constructor({ scene, world, base, ids, inlines, values }) {
        this.values = values;
        this.scene = scene;
        this.world = world;
        this.base = base;
        this.inlines = new Map(Array.from(ids).map((id, i) => [id, inlines[i]]));
    }

    show(stem, origin) {
        const inline = this.inlines.get(stem) ?? this.create(stem, origin);
        if (!inline.load) inline.load = true;
        else if (this.phase(stem) === 'failed') inline.url = inline.url;   // only so does it start again
    }

    hide(stem) {
        this.inlines.get(stem).load = false;
    }

    phase(stem) {
        const inline = this.inlines.get(stem);
        return loadPhase(inline.load, inline.getValue().checkLoadState());
    }

    /** Needs   phase(stem) == 'live'.   Fails   Error: no record in the file. */
    record(stem) {
        try {
            return recordFromMetadata(this.sceneOf(stem).getNamedNode('RECORD'));
        } catch (error) {
            throw new Error(`sector ${stem}: its file carries no RECORD that can be read: ${error.message}`);
        }
    }

    /** What a far file tells of where it leads; null: nothing. Needs   phase(stem) == 'live'. */
    links(stem) {
        try {
            return this.record(stem);
        } catch {
            return null;
        }
    }

    /** Needs   phase(stem) == 'live'. */
    setImpostor(stem, gate, opacity) {
        fadeImpostor(this.sceneOf(stem).getNamedNode(`IMPOSTOR-${gate}`), opacity);
    }

    /** Needs   phase(stem) == 'live'. */
    setPanorama(stem, opacity) {
        fadeImpostor(this.sceneOf(stem).getNamedNode('PANORAMA'), opacity);
    }

    /** Needs   phase(stem) == 'live'. */
    setDoor(stem, door, look) {
        const scene = this.sceneOf(stem);
        paintDoor(door, look, { find: name => scene.getNamedNode(name), ...this.values });
    }

    /** s: when a door was clicked last, 0: never. Needs   phase(stem) == 'live'. */
    touchTime(stem, door) {
        return this.sceneOf(stem).getNamedNode(`DOOR-TOUCH-${door}`).touchTime;
    }

    sceneOf(stem) {
        return this.inlines.get(stem).getValue().getInternalScene();
    }

    makeAlarm(seconds) {
        const alarm = this.scene.createNode('TimeSensor');
        alarm.cycleInterval = seconds;
        this.world.children[this.world.children.length] = alarm;
        return alarm;
    }

    create(stem, origin) {
        const place = this.scene.createNode('Transform'), inline = this.scene.createNode('Inline');
        inline.load = false;
        inline.url[0] = `${this.base}${stem}.x3d`;
        place.translation.x = origin[0];
        place.translation.z = -origin[1];
        place.children[0] = inline;
        this.world.children[this.world.children.length] = place;
        this.inlines.set(stem, inline);
        return inline;
    }
}

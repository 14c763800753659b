import { tightBox } from '../core/tightBox.js';

const kScales = [0.35, 0.6, 1, 1.6, 2.6, 4.2];   // CSS pixels per metre
const kGrounds = { street: '#fffdf8', crossroads: '#fffdf8', square: '#f7ecd2', yard: '#e3e9d6', passage: '#eee6da', open: '#dfe8d2' };
const kPaper = '#e8e1d3', kHouse = '#cbb9a4', kHouseEdge = '#a8947c', kInk = '#4a4036';
const kNear = 'rgba(240, 160, 60, 0.42)', kFar = 'rgba(70, 130, 190, 0.24)', kSeen = '#7a3fa0', kAvatar = '#1c6fd1', kRoute = '#d1491c';
const kClickPixels = 5;
const kLabelPixels = 70;     // a street shorter than this on the map bears no name

/**
 * The map beside the 3D view: sectors and houses of a CityPlan, what is loaded, where the visitor is and looks, and what
 * can be seen from his sector. North is up. A click goes there; a drag moves the map, until it is told to follow again.
 */
export class MapView {
    /** `go(east, north)`: a place was clicked. */
    constructor(canvas, plan, go) {
        Object.assign(this, { canvas, plan, go, zoom: 2, centre: null, drag: null, shown: '', seen: false, paths: new Map(), route: null });
        canvas.addEventListener('pointerdown', event => this.pointerDown(event));
        canvas.addEventListener('pointermove', event => this.pointerMove(event));
        canvas.addEventListener('pointerup', event => this.pointerUp(event));
        canvas.addEventListener('wheel', event => this.wheel(event), { passive: false });
    }

    get scale() {
        return kScales[this.zoom];
    }

    zoomBy(steps) {
        this.zoom = Math.min(kScales.length - 1, Math.max(0, this.zoom + steps));
    }

    follow() {
        this.centre = null;
    }

    /** m from the middle of the map to its corner. */
    get reach() {
        return Math.hypot(this.canvas.clientWidth, this.canvas.clientHeight) / 2 / this.scale;
    }

    /** Draws when something has changed. `sectors`: of Visit; `here`: the record of the visitor's sector or undefined. */
    show(pose, sectors, here) {
        const { clientWidth: width, clientHeight: height } = this.canvas, [east, north] = this.centre ?? [pose.east, pose.north];
        const files = sectors.filter(({ phase }) => phase === 'live').map(({ stem }) => stem);
        const pixels = [east, north, pose.east, pose.north].map(metres => (metres * this.scale).toFixed(1));
        const seen = [width, height, this.zoom, this.seen, here?.id, this.plan.version, pose.heading.toFixed(2)];
        const key = [...seen, ...pixels, ...files, this.route?.length ?? 0, ...(this.route?.at(-1) ?? [])].join(' ');
        if (key === this.shown || !width) return;
        this.shown = key;
        this.plan.around(east, north, this.reach);
        const ratio = Math.min(2, devicePixelRatio);
        if (this.canvas.width !== Math.round(width * ratio)) this.canvas.width = Math.round(width * ratio);
        if (this.canvas.height !== Math.round(height * ratio)) this.canvas.height = Math.round(height * ratio);
        this.middle = [east, north];
        const context = this.canvas.getContext('2d');
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.fillStyle = kPaper;
        context.fillRect(0, 0, this.canvas.width, this.canvas.height);
        const s = this.scale * ratio;
        context.setTransform(s, 0, 0, -s, this.canvas.width / 2 - east * s, this.canvas.height / 2 + north * s);
        this.drawGrounds(context, files, here);
        this.drawHouses(context);
        this.drawRoute(context);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        this.drawNames(context);
        this.drawAvatar(context, pose);
    }

    /** Plan metres -> CSS pixels of the canvas, and back. */
    pixel([east, north]) {
        const { clientWidth: width, clientHeight: height } = this.canvas, [x, y] = this.middle;
        return [width / 2 + (east - x) * this.scale, height / 2 - (north - y) * this.scale];
    }

    placeAt([x, y]) {
        const { clientWidth: width, clientHeight: height } = this.canvas, [east, north] = this.middle;
        return [east + (x - width / 2) / this.scale, north - (y - height / 2) / this.scale];
    }

    isInView({ box: [west, south, east, north] }) {
        const [x, y] = this.middle, reach = this.reach;
        return west < x + reach && east > x - reach && south < y + reach && north > y - reach;
    }

    path(place) {
        if (!this.paths.has(place)) {
            const path = new Path2D();
            for (const ring of place.rings) {
                path.moveTo(...ring[0]);
                for (const point of ring) path.lineTo(...point);
                path.closePath();
            }
            this.paths.set(place, path);
        }
        return this.paths.get(place);
    }

    drawGrounds(context, files, here) {
        const near = new Set(files), far = new Set(files.filter(stem => stem.includes('.')).map(stem => stem.split('.')[0]));
        const visible = new Set(this.seen ? here?.visible : []);
        const sectors = [...this.plan.sectors.values()].filter(sector => this.isInView(sector));
        for (const sector of sectors) {
            context.fillStyle = kGrounds[sector.kind] ?? kGrounds.street;
            context.fill(this.path(sector), 'evenodd');
            context.fillStyle = near.has(sector.id) ? kNear : far.has(sector.id) ? kFar : 'transparent';
            context.fill(this.path(sector), 'evenodd');
        }
        context.lineWidth = 0.6 / this.scale;
        context.strokeStyle = 'rgba(74, 64, 54, 0.28)';
        for (const sector of sectors) context.stroke(this.path(sector));
        context.lineWidth = 2.2 / this.scale;
        context.strokeStyle = kSeen;
        for (const sector of sectors) if (visible.has(sector.id)) context.stroke(this.path(sector));
    }

    drawHouses(context) {
        context.fillStyle = kHouse;
        context.strokeStyle = kHouseEdge;
        context.lineWidth = 0.8 / this.scale;
        for (const house of this.plan.houses.values()) {
            if (!this.isInView(house)) continue;
            context.fill(this.path(house), 'evenodd');
            if (this.scale > 0.5) context.stroke(this.path(house));
        }
    }

    /** The way of a tour, and where it ends. */
    drawRoute(context) {
        if (!this.route) return;
        context.lineJoin = context.lineCap = 'round';
        for (const [colour, pixels] of [['#ffffff', 8], [kRoute, 4.5]]) {
            context.strokeStyle = colour;
            context.lineWidth = pixels / this.scale;
            context.beginPath();
            for (const [east, north] of this.route) context.lineTo(east, north);
            context.stroke();
        }
        const [east, north] = this.route.at(-1);
        context.fillStyle = kRoute;
        context.strokeStyle = '#ffffff';
        context.lineWidth = 2 / this.scale;
        context.beginPath();
        context.arc(east, north, 7 / this.scale, 0, 2 * Math.PI);
        context.fill();
        context.stroke();
    }

    /** Each street's name once, along its longest sector in view. */
    drawNames(context) {
        const longest = new Map();
        for (const sector of this.plan.sectors.values()) {
            if (!sector.name || !this.isInView(sector)) continue;
            const { half } = tightBoxOf(sector), best = longest.get(sector.name);
            if (!best || half[0] > best.half) longest.set(sector.name, { sector, half: Math.max(...half) });
        }
        context.font = '500 11px "Inter", "Segoe UI", "DejaVu Sans", sans-serif';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        for (const [name, { sector, half }] of longest) {
            if (2 * half * this.scale < kLabelPixels) continue;
            const { centre, along, half: [u, v] } = tightBoxOf(sector), [x, y] = this.pixel(centre);
            const angle = Math.atan2(...(u >= v ? [-along[1], along[0]] : [-along[0], -along[1]]));
            context.save();
            context.translate(x, y);
            context.rotate(Math.cos(angle) < 0 ? angle + Math.PI : angle);
            context.lineWidth = 3;
            context.strokeStyle = 'rgba(255, 253, 248, 0.9)';
            context.strokeText(name, 0, 0);
            context.fillStyle = kInk;
            context.fillText(name, 0, 0);
            context.restore();
        }
    }

    drawAvatar(context, { east, north, heading }) {
        context.save();
        context.translate(...this.pixel([east, north]));
        context.rotate(heading);
        const cone = context.createRadialGradient(0, 0, 4, 0, 0, 46);
        cone.addColorStop(0, 'rgba(28, 111, 209, 0.5)');
        cone.addColorStop(1, 'rgba(28, 111, 209, 0)');
        context.fillStyle = cone;
        context.beginPath();
        context.moveTo(0, 0);
        context.arc(0, 0, 46, -Math.PI / 2 - 0.5, -Math.PI / 2 + 0.5);
        context.fill();
        context.beginPath();
        context.moveTo(0, -11);
        context.lineTo(7.5, 8);
        context.lineTo(0, 4.5);
        context.lineTo(-7.5, 8);
        context.closePath();
        context.fillStyle = kAvatar;
        context.strokeStyle = '#fff';
        context.lineWidth = 2;
        context.stroke();
        context.fill();
        context.restore();
    }

    pointerDown(event) {
        this.drag = { x: event.offsetX, y: event.offsetY, centre: this.middle, moved: false };
        this.canvas.setPointerCapture(event.pointerId);
    }

    pointerMove(event) {
        if (!this.drag) return;
        const dx = event.offsetX - this.drag.x, dy = event.offsetY - this.drag.y;
        this.drag.moved ||= Math.hypot(dx, dy) > kClickPixels;
        if (this.drag.moved) this.centre = [this.drag.centre[0] - dx / this.scale, this.drag.centre[1] + dy / this.scale];
    }

    pointerUp(event) {
        const isClick = this.drag && !this.drag.moved;
        this.drag = null;
        if (isClick && this.middle) this.go(...this.placeAt([event.offsetX, event.offsetY]));
    }

    wheel(event) {
        event.preventDefault();
        this.zoomBy(event.deltaY < 0 ? 1 : -1);
    }
}

const kTight = new WeakMap();

function tightBoxOf(sector) {
    if (!kTight.has(sector)) kTight.set(sector, tightBox({ ground: sector.rings }));
    return kTight.get(sector);
}
